//! A marker that a rigid body does not have, and one that a generated body does not have.
ffrf::flexible_body! {
    pub struct Beam { model: "models/sound.ffrf.json" }
}

ffrf::mechanism! {
    pub struct Written {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: { pin: revolute(ground, bar.TIP, axis: y) },
    }
}

ffrf::mechanism! {
    pub struct Generated {
        bodies: { beam: Beam },
        joints: { pin: revolute(ground, beam.BIG_END, axis: y) },
    }
}

fn main() {}
