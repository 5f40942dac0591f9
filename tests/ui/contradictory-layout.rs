//! A mode-mode moment without trace, where its trace is the modal mass.
ffrf::flexible_body! {
    pub struct Body { modes: 2, layout: { mode_mode_moment: antisymmetric, modal_mass: identity } }
}

fn main() {}
