//! The connecting rod of the main example with no, four and eight modes, in both scalars, contraction off.

macro_rules! rod {
    ($($name:ident: $modes:tt, $scalar:ident;)*) => {$(
        ffrf::flexible_body! {
            /// The connecting rod.
            pub struct $name { model: "../../models/conrod.ffrf.json", modes: ..$modes, scalar: $scalar, fma: off }
        }
    )*};
}

rod! {
    Rigid32: 0, f32;
    Four32: 4, f32;
    Eight32: 8, f32;
    Rigid64: 0, f64;
    Four64: 4, f64;
    Eight64: 8, f64;
}
