//! Both a model and a layout.
ffrf::flexible_body! {
    pub struct Body { model: "body.ffrf.json", layout: {} }
}

fn main() {}
