//! Names that are given twice or taken.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }, bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }, ground: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }, gravity: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: { pin: revolute(ground, bar, axis: y), pin: revolute(ground, bar, axis: y) },
        sensors: { pin: position(bar), at_rest: position(bar) },
        gravity: [0.0, 0.0, 0.0],
        gravity: [0.0, 0.0, -9.81],
    }
}

fn main() {}
