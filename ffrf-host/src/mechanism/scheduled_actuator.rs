//! Actuators whose input is a function of time.

use ffrf_runtime::forces::Effort;
use ffrf_runtime::mechanism::{Attachment, Ports};

use nalgebra::{RealField, convert, try_convert};

use super::Drive;

/// A force or moment between two attachments that follows an input over time.
#[derive(Debug, Clone, PartialEq)]
pub struct ScheduledActuator<T: RealField + Copy = f64> {
    /// Where it acts.
    pub effort: Effort,
    /// Its input; the derivatives are of no effect.
    pub input: Drive,
    /// What is added to the input: zero, or a small change whose effect is asked for.
    pub added: T,
    /// Force or moment per unit of the input. Units: N or N m per unit.
    pub gain: f64,
    /// The largest force or moment it can exert, either way. Units: N or N m.
    pub limit: f64,
    /// Where it begins.
    pub first: Attachment<T>,
    /// Where it acts.
    pub second: Attachment<T>,
}

impl<T: RealField + Copy> ScheduledActuator<T> {
    /// Adds its wrenches at `time` (s) to the forces on the bodies.
    pub fn apply(&self, time: T, ports: &mut dyn Ports<T>) {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        let wrenches = self.effort.wrenches(&first, &second, self.exerted(time));
        for (attachment, wrench) in [&self.first, &self.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| ports.port_mut(body)) {
                port.push(attachment.marker, wrench);
            }
        }
    }

    /// The force or moment at `time`: `gain` times the input, at most the limit. Units: N or N m.
    pub fn exerted(&self, time: T) -> T {
        // time is a plain number in every type: nothing is differentiated by it
        let [input, ..] = self.input.at(try_convert(time).unwrap_or(f64::NAN));
        let (gain, limit): (T, T) = (convert(self.gain), convert(self.limit));
        (gain * (convert::<f64, T>(input) + self.added)).clamp(-limit, limit)
    }
}

impl ScheduledActuator {
    /// The same actuator in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> ScheduledActuator<T> {
        ScheduledActuator {
            effort: self.effort,
            input: self.input.clone(),
            added: convert(self.added),
            gain: self.gain,
            limit: self.limit,
            first: self.first.cast(),
            second: self.second.cast(),
        }
    }
}
