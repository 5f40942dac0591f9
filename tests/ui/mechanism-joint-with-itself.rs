//! Joints that connect nothing to anything.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }, links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }; 3] },
        joints: {
            pin: revolute(bar, bar.END, axis: y),
            foundation: fixed(ground, ground.at([1.0, 0.0, 0.0])),
            hinges: for i in 0..3 { revolute(links[i].END, links[2 - i], axis: y) },
        },
        forces: { coil: spring(bar, bar.END, stiffness: 1.0, rest_length: 0.1) },
    }
}

fn main() {}
