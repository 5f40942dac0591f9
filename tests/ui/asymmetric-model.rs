//! A model that fails its consistency checks is refused at its path.
ffrf::flexible_body! {
    pub struct Body { model: "models/asymmetric.ffrf.json" }
}

fn main() {}
