//! A mode that the model does not have; modes count from 0.
ffrf::flexible_body! {
    pub struct Body { model: "models/sound.ffrf.json", modes: [0, 4] }
}

fn main() {}
