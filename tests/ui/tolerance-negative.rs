//! A tolerance below zero.
ffrf::flexible_body! {
    pub struct Body { model: "models/missing.ffrf.json", layout_tolerance: -1e-9 }
}

fn main() {}
