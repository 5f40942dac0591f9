//! More modes than the model has.
ffrf::flexible_body! {
    pub struct Body { model: "models/sound.ffrf.json", modes: ..9 }
}

fn main() {}
