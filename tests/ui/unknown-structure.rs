//! A structure that does not exist.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: { first_moment: sparse } }
}

fn main() {}
