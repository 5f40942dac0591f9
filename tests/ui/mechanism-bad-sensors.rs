//! Sensors of what does not exist, or has no such quantity.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: { pin: revolute(ground, bar, axis: y), ball: spherical(ground, bar.END) },
        sensors: {
            one: reaction_force(bar),
            two: angle(ball),
            three: position(pin),
            four: position(bar, ground),
            five: position(bar, axis: x),
        },
    }
}

fn main() {}
