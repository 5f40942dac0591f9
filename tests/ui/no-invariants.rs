//! Neither a model nor a layout.
ffrf::flexible_body! {
    pub struct Body { scalar: f64 }
}

fn main() {}
