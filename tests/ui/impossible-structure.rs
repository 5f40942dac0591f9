//! A structure that the invariant cannot have.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: { modal_mass: zero } }
}

fn main() {}
