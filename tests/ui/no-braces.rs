//! A struct without fields.
ffrf::flexible_body! {
    pub struct Body;
}

fn main() {}
