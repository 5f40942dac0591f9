//! More modes than the model has, in one member.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: [2, 9], scalar: [f64, f32] }
}

fn main() {}
