//! A range of modes without a mode.
ffrf::flexible_body! {
    pub struct Body { model: "models/sound.ffrf.json", modes: 3..3 }
}

fn main() {}
