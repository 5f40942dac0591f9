//! Several mistakes are reported at once, and the use of the type is not one more.
ffrf::flexible_body! {
    pub struct Body { modes: many, layout: { mass: zero }, scalar: f16, colour: red }
}

fn main() {
    let _ = Body;
}
