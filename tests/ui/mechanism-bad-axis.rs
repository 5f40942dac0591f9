//! Axes that are none.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: {
            one: revolute(ground, bar, axis: w),
            two: revolute(ground, bar, axis: [1.0, 0.0]),
            three: revolute(ground, bar, axis: (x, y, z)),
            four: revolute(ground, bar, axis: x, axis: y),
        },
    }
}

fn main() {}
