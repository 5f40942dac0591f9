//! A fidelity that does not exist among others.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: [2], fidelity: [full, exact] }
}

fn main() {}
