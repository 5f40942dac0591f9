//! A model file that is not there.
ffrf::flexible_body! {
    pub struct Body { model: "models/missing.ffrf.json" }
}

fn main() {}
