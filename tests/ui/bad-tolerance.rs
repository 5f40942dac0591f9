//! A layout tolerance that is no relative tolerance.
ffrf::flexible_body! {
    pub struct Body { model: "models/missing.ffrf.json", layout_tolerance: 2.0 }
}

fn main() {}
