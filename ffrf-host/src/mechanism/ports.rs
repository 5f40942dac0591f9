//! What a mechanism of run-time size shows of its bodies in one state.

use ffrf_runtime::mechanism::{AttachedRows, BodyPort, KeptModes, Port, Ports};
use nalgebra::RealField;

use crate::{HostBody, HostModal};

/// The bodies of a mechanism in one state.
pub struct HostPorts<'a, T: RealField + Copy = f64>(pub Vec<HostPort<'a, T>>);

/// One body of a mechanism in one state.
pub type HostPort<'a, T = f64> =
    BodyPort<'a, HostBody<T>, Vec<AttachedRows<HostModal<T>, T>>, T, Option<KeptModes<HostModal<T>, T>>>;

impl<T: RealField + Copy> Ports<T> for HostPorts<'_, T> {
    fn port(&self, index: usize) -> Option<&dyn Port<T>> {
        self.0.get(index).map(|port| port as &dyn Port<T>)
    }

    fn port_mut(&mut self, index: usize) -> Option<&mut dyn Port<T>> {
        self.0.get_mut(index).map(|port| port as &mut dyn Port<T>)
    }
}
