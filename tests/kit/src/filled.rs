//! Bodies whose invariants come at run time, in the general layout.

/// The fields of a body as a macro call names them, from a model.
#[macro_export]
macro_rules! filled {
    ($name:ident, $body:expr, $number:ty) => {{
        let given = $crate::witness::invariants(&$body);
        let vector = |v: [f64; 3]| v.map(|x| x as $number);
        $name {
            mass: given.mass as $number,
            first_moment: vector($body.inertia.first_moment),
            modal_first_moment: std::array::from_fn(|mu| vector($body.inertia.modal_first_moment[mu])),
            second_moment: given.euler_tensor.map(vector),
            position_mode_moment: given.modal_euler_tensor.map(|moment| moment.map(vector)),
            mode_mode_moment: given.modal_pair_euler_tensor.map(|row| row.map(|moment| moment.map(vector))),
            stiffness: given.stiffness.map(|row| row.map(|k| k as $number)),
            damping: given.damping.map(|row| row.map(|d| d as $number)),
        }
    }};
}
