//! Loads: everything that pushes bodies, as generalised forces added without allocation.

use nalgebra::RealField;

/// Something that adds to the forces `F` on bodies `B` in a state `S`.
///
/// For one body, `B` is its type, `S` its [`State`](crate::State) and `F` a
/// [`GeneralisedForce`](crate::GeneralisedForce); for several bodies they hold those of all of them, so that a load can
/// act between bodies. Closures with the arguments of [`add_to`](Self::add_to) are loads, and so are `()` (no load) and
/// tuples of up to four loads (their sum). Write the argument types of a closure out:
///
/// ```
/// use ffrf_runtime::nalgebra::SVector;
/// use ffrf_runtime::{GeneralisedForce, Load, State};
///
/// type Modal = SVector<f64, 2>;
/// # struct Body;
/// fn is_a_load<B>(load: impl Load<B, State<Modal>, GeneralisedForce<Modal>>) -> impl Load<B, State<Modal>, GeneralisedForce<Modal>> {
///     load
/// }
/// // a moment about the body's z axis that grows with time
/// let _ = is_a_load(|_: &Body, time: f64, _: &State<Modal>, force: &mut GeneralisedForce<Modal>| {
///     force.moment.z += 0.1 * time
/// });
/// ```
pub trait Load<B, S, F, T: RealField + Copy = f64> {
    /// Adds the forces at `time` (s) in `state` to `force`.
    ///
    /// Called a few times per step, also at states that no step accepts. Must not panic.
    fn add_to(&self, bodies: &B, time: T, state: &S, force: &mut F);
}

impl<L, B, S, F, T: RealField + Copy> Load<B, S, F, T> for L
where
    L: Fn(&B, T, &S, &mut F),
{
    fn add_to(&self, bodies: &B, time: T, state: &S, force: &mut F) {
        self(bodies, time, state, force);
    }
}

/// No load at all.
impl<B, S, F, T: RealField + Copy> Load<B, S, F, T> for () {
    fn add_to(&self, _: &B, _: T, _: &S, _: &mut F) {}
}

macro_rules! sum_of_loads {
    ($($name:ident $index:tt),+) => {
        /// The sum of the loads.
        impl<B, S, F, T: RealField + Copy, $($name: Load<B, S, F, T>,)+> Load<B, S, F, T> for ($($name,)+) {
            fn add_to(&self, bodies: &B, time: T, state: &S, force: &mut F) {
                $(self.$index.add_to(bodies, time, state, force);)+
            }
        }
    };
}
sum_of_loads!(L0 0, L1 1);
sum_of_loads!(L0 0, L1 1, L2 2);
sum_of_loads!(L0 0, L1 1, L2 2, L3 3);
