//! Actuators whose input is a function of time.

use ffrf_runtime::forces::Effort;
use ffrf_runtime::mechanism::{Attachment, Ports};

use super::Drive;

/// A force or moment between two attachments that follows an input over time.
#[derive(Debug, Clone, PartialEq)]
pub struct ScheduledActuator {
    /// Where it acts.
    pub effort: Effort,
    /// Its input; the derivatives are of no effect.
    pub input: Drive,
    /// Force or moment per unit of the input. Units: N or N m per unit.
    pub gain: f64,
    /// The largest force or moment it can exert, either way. Units: N or N m.
    pub limit: f64,
    /// Where it begins.
    pub first: Attachment<f64>,
    /// Where it acts.
    pub second: Attachment<f64>,
}

impl ScheduledActuator {
    /// Adds its wrenches at `time` (s) to the forces on the bodies.
    pub fn apply(&self, time: f64, ports: &mut dyn Ports<f64>) {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        let wrenches = self.effort.wrenches(&first, &second, self.exerted(time));
        for (attachment, wrench) in [&self.first, &self.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| ports.port_mut(body)) {
                port.push(attachment.marker, wrench);
            }
        }
    }

    /// The force or moment at `time`: `gain` times the input, at most the limit. Units: N or N m.
    pub fn exerted(&self, time: f64) -> f64 {
        let [input, ..] = self.input.at(time);
        (self.gain * input).clamp(-self.limit, self.limit)
    }
}
