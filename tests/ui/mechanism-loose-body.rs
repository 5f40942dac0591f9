//! Bodies without joints.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: {
            bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } },
            ball: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] },
            links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] }; 3],
        },
        joints: {
            pin: revolute(ground, bar, axis: y),
            hinges: for i in 0..2 { revolute(bar.END, links[2 * i], axis: y) },
        },
    }
}

fn main() {}
