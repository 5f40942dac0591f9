//! A function that was printed for another mechanism.
fn of_one_body(_: &[f64; 13], _: &[[f64; 3]; 1], _: &mut [f64; 6]) -> bool {
    false
}

ffrf::mechanism! {
    pub struct Two {
        bodies: {
            bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] },
            other: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] },
        },
        joints: { pin: revolute(ground, bar, axis: y), hinge: revolute(bar, other, axis: y) },
        accelerations: of_one_body,
    }
}

fn main() {}
