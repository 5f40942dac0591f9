//! A layout that is no list of invariants.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: free_free }
}

fn main() {}
