//! A number type that cannot be measured.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: [2], scalar: [f64, generic] }
}

fn main() {}
