//! Rigid bodies that lack something.
ffrf::mechanism! {
    pub struct One { bodies: { bar: rigid { inertia: [0.1, 0.1, 0.1] } } }
}

ffrf::mechanism! {
    pub struct Two { bodies: { bar: rigid { mass: 1.0 } } }
}

ffrf::mechanism! {
    pub struct Three { bodies: { bar: rigid { mass: 1.0, weight: 9.81, inertia: [0.1, 0.1, 0.1] } } }
}

ffrf::mechanism! {
    pub struct Four { bodies: { bar: rigid { mass: 1.0, mass: 2.0, inertia: [0.1, 0.1, 0.1] } } }
}

fn main() {}
