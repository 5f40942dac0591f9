//! What the rows of joints are to do, and bodies on their supports.

use nalgebra::RealField;

use super::beyond::beyond;
use super::standing::{end_on_body, stands};
use super::{Constraints, EvaluatedJoint, Support, Target};
use crate::relations::add_powers;
use crate::six::{add_scaled, scaled};

impl<T: RealField + Copy> Constraints<'_, '_, T> {
    /// Puts bodies that have their factors on their supports.
    pub(super) fn put_on_supports(&mut self) {
        let joints = self.plan.joints.iter().zip(self.connections).zip(self.storage.joints.iter());
        for ((place, connection), joint) in joints.filter(|((place, _), _)| place.is_support) {
            let (Some((body, slot, is_second)), Some(joint)) = (end_on_body(place), joint) else { continue };
            let Some(port) = self.ports.port_mut(body) else { continue };
            let attachment = if is_second { &connection.second } else { &connection.first };
            let [_, rows] = joint.rows.gradients();
            let support = Support {
                slot,
                marker: attachment.marker,
                beyond: beyond(connection, joint, is_second),
                sign: if is_second { T::one() } else { -T::one() },
                rows,
                counts: [joint.rows.len(), connection.kind.held_translations()],
                holds_point: connection.kind.holds_point(),
            };
            port.stand_on(&support);
        }
    }

    /// Asks of supports what their rows are to do.
    pub(super) fn ask_of_supports(&mut self, target: Target<T>) {
        for (number, place) in self.plan.joints.iter().enumerate().take(self.connections.len()) {
            if !place.is_support || !stands(self.ports, place) {
                continue;
            }
            let wanted = self.wanted(number, target);
            let port = end_on_body(place).and_then(|(body, ..)| self.ports.port_mut(body));
            if let (Some(port), Some(wanted)) = (port, wanted) {
                port.ask_of_support(&wanted);
            }
        }
    }

    /// Sets the right-hand side of the rows of a joint: what they are to do, less what bodies do on their own; `with_modes`: their
    /// modes as well.
    pub(super) fn put_wanted(&mut self, number: usize, target: Target<T>, with_modes: bool) {
        let (Some(mut wanted), Some(place)) = (self.wanted(number, target), self.plan.joints.get(number))
        else {
            return;
        };
        if place.is_support && self.supported && stands(self.ports, place) {
            wanted = [T::zero(); 6];
        } else if let (Some(connection), Some(Some(joint))) =
            (self.connections.get(number), self.storage.joints.get(number))
        {
            let ends = place.ends.iter().zip([&connection.first, &connection.second]);
            for ((end, attachment), gradients) in ends.zip(joint.rows.gradients()) {
                let Some(end) = end else { continue };
                let Some(port) = self.ports.port(end.body) else { continue };
                if with_modes {
                    port.subtract_modal_accelerations(end.slot, &mut wanted);
                }
                if !self.supported {
                    continue;
                }
                if let Some([linear, angular]) = port.supported_twist(attachment.marker) {
                    add_powers(&mut wanted, gradients, &-linear, &-angular);
                }
            }
        }
        if let Some(right) = self.storage.right.get_mut(place.node) {
            *right = wanted;
        }
    }

    /// What the rows of a joint are to do.
    fn wanted(&self, number: usize, target: Target<T>) -> Option<[T; 6]> {
        let connection = self.connections.get(number)?;
        let EvaluatedJoint { rows, ends } = self.storage.joints.get(number)?.as_ref()?;
        let Target::Acceleration { gains: [damping, stiffness] } = target else {
            return Some(match target {
                Target::Velocity { share } => scaled(-T::one() / share, &rows.velocities(ends)),
                Target::Position { share } => scaled(-T::one() / share, rows.residuals()),
                _ => *rows.residuals(),
            });
        };
        let mut wanted = rows.whole_biases(ends);
        if damping != T::zero() || stiffness != T::zero() {
            add_scaled(&mut wanted, damping, &rows.velocities(ends));
            add_scaled(&mut wanted, stiffness, rows.residuals());
        }
        wanted = scaled(-T::one(), &wanted);
        for (attachment, gradients) in
            [&connection.first, &connection.second].into_iter().zip(rows.gradients())
        {
            let port = attachment.body.and_then(|body| self.ports.port(body));
            if let Some([linear, angular]) = port.and_then(|port| port.subtracted_twist(attachment.marker)) {
                add_powers(&mut wanted, gradients, &-linear, &-angular);
            }
        }
        Some(wanted)
    }
}
