//! A choice of contraction that does not exist.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, fma: maybe }
}

fn main() {}
