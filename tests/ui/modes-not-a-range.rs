//! A number of modes with a model: the first eight are written `..8`.
ffrf::flexible_body! {
    pub struct Body { model: "models/missing.ffrf.json", modes: 8 }
}

fn main() {}
