//! Lanes compute what the interpreter and the naive form compute: every layout, with and without padding.

use ffrf_codegen::Kernels;
use ffrf_test_kit::witness;
use kernels::cases;

fn find(name: &str) -> (Kernels, ffrf_model::ReducedBody) {
    let case = cases::all().into_iter().find(|case| case.name == name).unwrap();
    (Kernels::formulate(&case.body, &case.options).unwrap(), case.body)
}

macro_rules! agree {
    ($full:literal; $($name:ident $modes:literal $size:literal;)*) => {$(
        #[test]
        fn $name() {
            let (kernels, body) = find(stringify!($name));
            witness::check::<$modes, $size, _>(&kernels::$name::Body, &body, &kernels, $full);
        }
    )*};
}

agree! { true;
    lanes_m1 1 7;
    lanes_m2 2 8;
    lanes_m3 3 9;
    lanes_m4 4 10;
    lanes_m5 5 11;
    lanes_m6 6 12;
    lanes_m7 7 13;
    lanes_m8 8 14;
    lanes_m9 9 15;
    lanes_m12 12 18;
    lanes_m16 16 22;
    lanes_m17 17 23;
    lanes_m20 20 26;
    lanes_m21 21 27;
    lanes_m33 33 39;
    lanes_free_free_m3 3 9;
    lanes_free_free_m9 9 15;
    lanes_free_free_m21 21 27;
    lanes_diagonal_m3 3 9;
    lanes_diagonal_m9 9 15;
    lanes_diagonal_m21 21 27;
    lanes_dense_m3 3 9;
    lanes_dense_m4 4 10;
    lanes_dense_m5 5 11;
    lanes_dense_m9 9 15;
    lanes_dense_m16 16 22;
    lanes_dense_m21 21 27;
}

agree! { false;
    lanes_linear_m3 3 9;
    lanes_linear_m9 9 15;
    lanes_linear_m21 21 27;
    lanes_constant_m6 6 12;
}

macro_rules! agree_single {
    ($($name:ident $modes:literal $size:literal;)*) => {$(
        #[test]
        fn $name() {
            let (kernels, _) = find(stringify!($name));
            witness::check_single::<$modes, $size, _>(&kernels::$name::Body, &kernels);
        }
    )*};
}

agree_single! {
    lanes_single_m3 3 9;
    lanes_single_m9 9 15;
    lanes_single_m21 21 27;
    lanes_single_m28 28 34;
    lanes_dense_single_m9 9 15;
}
