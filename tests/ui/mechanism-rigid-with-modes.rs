//! A body that is said to be rigid, but has modes.
ffrf::flexible_body! {
    pub struct Beam { model: "models/sound.ffrf.json" }
}

ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { beam: rigid Beam },
        joints: { pin: revolute(ground, beam.ROOT, axis: y) },
    }
}

fn main() {}
