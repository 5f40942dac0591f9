//! The checks run whatever else is asked for.
ffrf::flexible_body! {
    pub struct Body { model: "models/negative_damping.ffrf.json", modes: ..2, strategy: lanes }
}

fn main() {}
