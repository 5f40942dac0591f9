//! What a mechanism of run-time size shows of its bodies in one state.

use ffrf_runtime::Increment;
use ffrf_runtime::mechanism::{AttachedRows, BodyPort, ImplicitTerms, KeptModes, Port, Ports, Room};
use nalgebra::RealField;

use super::HostIncrement;
use crate::{HostBody, HostModal};

/// The bodies of a mechanism in one state.
pub struct HostPorts<'a, T: RealField + Copy = f64>(pub Vec<HostPort<'a, T>>);

/// One body of a mechanism in one state.
pub type HostPort<'a, T = f64> = BodyPort<'a, HostBody<T>, HostRows<T>, T, HostKept<T>>;

/// Room for what the equations need of one body.
pub type HostRoom<T = f64> = Room<HostModal<T>, HostRows<T>, T, HostKept<T>>;

type HostRows<T> = Vec<Option<AttachedRows<HostModal<T>, T>>>;
type HostKept<T> = Option<KeptModes<HostModal<T>, T>>;

/// What a linearly implicit stage of all bodies adds to the evaluation of one.
pub(super) fn terms_of<'a, T: RealField + Copy>(
    all: &ImplicitTerms<'a, HostIncrement<T>, T>,
    body: usize,
) -> ImplicitTerms<'a, Increment<HostModal<T>, T>, T> {
    ImplicitTerms {
        gamma_h: all.gamma_h,
        subtracted: all.subtracted.and_then(|all| all.0.get(body)),
        chart: all.chart.and_then(|all| all.0.get(body)),
    }
}

impl<T: RealField + Copy> Ports<T> for HostPorts<'_, T> {
    fn port(&self, index: usize) -> Option<&dyn Port<T>> {
        self.0.get(index).map(|port| port as &dyn Port<T>)
    }

    fn port_mut(&mut self, index: usize) -> Option<&mut dyn Port<T>> {
        self.0.get_mut(index).map(|port| port as &mut dyn Port<T>)
    }
}
