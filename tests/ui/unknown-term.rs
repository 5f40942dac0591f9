//! Energy terms that do not exist: one message each.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, fidelity: [translation, translatoin, spin] }
}

fn main() {}
