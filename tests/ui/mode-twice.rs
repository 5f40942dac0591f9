//! A mode that is asked for twice.
ffrf::flexible_body! {
    pub struct Body { model: "models/sound.ffrf.json", modes: [1, 2, 1] }
}

fn main() {}
