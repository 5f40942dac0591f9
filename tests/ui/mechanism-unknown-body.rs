//! Ends on bodies that do not exist.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: { pin: revolute(ground, beam.END, axis: y) },
        forces: { push: force(rod, value: [1.0, 0.0, 0.0]) },
        sensors: { tip: position(bra.END) },
    }
}

fn main() {}
