//! One body of a tree in the sweep over it.

use nalgebra::{RealField, Vector3};

use super::room::attached;
use super::solved::Solved;
use super::tree::Woven;
use super::{AttachedRows, BodyPort, ImplicitTerms, Limb, LimbEnd, TreePort};
use crate::body::{FlexibleBody, ModalVector, implicit_modal_mass, implicit_right, with_placed};
use crate::six::Square;

impl<B, R, T, K> TreePort<T> for BodyPort<'_, B, R, T, K>
where
    B: FlexibleBody<T>,
    R: AsRef<[Option<AttachedRows<B::Modal, T>>]> + AsMut<[Option<AttachedRows<B::Modal, T>>]>,
    T: RealField + Copy,
{
    fn reach(&mut self, end: &LimbEnd<T>) -> Vector3<T> {
        let places = self.room.rows.as_mut();
        let (Some(marker), Some(place)) = (self.markers.get(end.marker), places.get_mut(end.slot)) else {
            return end.beyond;
        };
        let rows = AttachedRows::put(place, &self.alone);
        let arm = with_placed(self.body, marker, &self.state, &self.axes, |placed| {
            placed.modal_twists(&end.beyond, rows.modal.as_mut());
            placed.arm()
        });
        end.beyond + self.axes * arm
    }

    fn resist(&mut self, limb: &mut Limb<T>) {
        let (body, state) = (self.body, &self.state);
        let prepared = body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
        self.net = match self.implicit {
            None => prepared.net_force(&self.force),
            Some(ImplicitTerms { gamma_h, subtracted, .. }) => {
                implicit_right(&prepared, body, state, &self.force, gamma_h, subtracted)
            }
        };
        limb.set_rigid(prepared.mass, &prepared.first_moment, &prepared.inertia, &self.axes);
        limb.has_modes = !self.alone.as_slice().is_empty();
        if !limb.has_modes {
            return;
        }
        let modal = match self.implicit {
            None => body.modal_mass(),
            Some(ImplicitTerms { gamma_h, .. }) => implicit_modal_mass(body, gamma_h),
        };
        let mut coupling = prepared.coupling_sixes();
        for six in coupling.as_mut() {
            *six = limb.at_root(&self.axes, six);
        }
        self.room.solved = Solved::Tree(Woven::new(coupling, modal.dense(), self.alone.clone()));
    }

    fn bear(&mut self, slot: usize, inertia: &Square<T>, arm: &Vector3<T>) {
        if let (Some(woven), Some(rows)) = (self.room.solved.woven_mut(), attached(&self.room.rows, slot)) {
            woven.bear(inertia, rows.modal.as_ref(), arm);
        }
    }

    fn close(&mut self, limb: &mut Limb<T>, root: Option<usize>) -> Option<()> {
        let Some(woven) = self.room.solved.woven_mut() else { return Some(()) };
        if let Some(rows) = root.and_then(|slot| attached(&self.room.rows, slot)) {
            woven.lean(&limb.inertia, rows.modal.as_ref());
        }
        woven.eliminate(&mut limb.inertia)
    }

    fn force_on(&mut self, limb: &mut Limb<T>, with_forces: bool) {
        if with_forces {
            limb.set_force(&(self.axes * self.net.force), &(self.axes * self.net.moment));
        } else {
            limb.force = [T::zero(); 6];
        }
        if let Some(woven) = self.room.solved.woven_mut() {
            woven.force.clone_from(if with_forces { &self.net.modal } else { &self.alone });
        }
    }

    fn bear_force(&mut self, slot: usize, force: &[T; 6]) {
        if let (Some(woven), Some(rows)) = (self.room.solved.woven_mut(), attached(&self.room.rows, slot)) {
            woven.push(force, rows.modal.as_ref(), T::one());
        }
    }

    fn yield_to(&mut self, limb: &mut Limb<T>, root: Option<usize>) {
        let Some(woven) = self.room.solved.woven_mut() else { return };
        if let Some(rows) = root.and_then(|slot| attached(&self.room.rows, slot)) {
            woven.push(&limb.force, rows.modal.as_ref(), -T::one());
        }
        woven.yield_to(&mut limb.force);
    }

    fn move_with(&mut self, limb: &mut Limb<T>, root: Option<usize>) {
        if let Some(woven) = self.room.solved.woven_mut() {
            woven.follow(&limb.twist);
            if let Some(rows) = root.and_then(|slot| attached(&self.room.rows, slot)) {
                woven.carry(&mut limb.twist, rows.modal.as_ref(), -T::one());
            }
            self.motion.modal.clone_from(&woven.force);
        }
        [self.motion.linear, self.motion.angular] = limb.frame_motion();
    }

    fn carry(&self, slot: usize, twist: &mut [T; 6]) {
        if let (Some(woven), Some(rows)) = (self.room.solved.woven(), attached(&self.room.rows, slot)) {
            woven.carry(twist, rows.modal.as_ref(), T::one());
        }
    }
}
