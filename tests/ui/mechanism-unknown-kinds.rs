//! Kinds and options that do not exist.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: {
            pin: hinge(ground, bar),
            other: revolute(ground, bar, length: 1.0),
            third: spherical(ground, bar, axis: y),
            fourth: revolute(bar),
            fifth: distance(ground, bar),
            sixth: generic(ground, bar),
            seventh: generic(ground, bar, translation: [true, false]),
        },
        drives: { motor: torque(other) },
        forces: {
            push: thrust(bar),
            coil: spring(ground, bar, rest_length: 1.0),
            pull: force(bar, value: [0.0, 0.0, 1.0], frame: world),
        },
        sensors: { tip: place(bar) },
        damping: 0.1,
        scalar: f16,
    }
}

fn main() {}
