//! The dense mass matrix.

use super::equations::State;
use super::groups::{Register, four, load, ungroup, zero};
use super::{Four, LaneBody, Lanes, ModalMatrix, Registers, Scalar};

impl<C: Copy, const M: usize, const G: usize, P, R> LaneBody<'_, C, M, G, P, R> {
    /// Writes M(q), columns of N = 6 + M entries. Source: (203), body-resolved, signs corrected.
    #[inline(always)]
    pub(super) fn write_mass_matrix<T: Scalar<Constant = C>, const N: usize>(
        &self,
        state: &State<T, G>,
        columns: &mut [[T; N]; N],
    ) where
        R: Registers<T>,
    {
        const { assert!(N == 6 + M) };
        let none = T::zero();
        let (mass, [x, y, z]) = (T::constant(self.mass), state.first_moment);
        let [xx, yy, zz, xy, xz, yz] = state.inertia;
        let rigid = [
            [mass, none, none, none, z, -y],
            [none, mass, none, -z, none, x],
            [none, none, mass, y, -x, none],
            [none, -z, y, xx, xy, xz],
            [z, none, -x, xy, yy, yz],
            [-y, x, none, xz, yz, zz],
        ];
        let (left, right) = columns.split_at_mut(6);
        for (column, rigid) in left.iter_mut().zip(rigid) {
            column[..6].copy_from_slice(&rigid);
        }
        let (along, about) = left.split_at_mut(3);
        let [along_x, along_y, along_z] = along else { return };
        let [about_x, about_y, about_z] = about else { return };
        let columns = [(0, along_x, about_x), (1, along_y, about_y), (2, along_z, about_z)];
        for (axis, along, about) in columns {
            match self.modal_first_moment {
                None => along[6..].fill(none),
                Some(moments) => ungroup(|g| moments[g][axis].map(T::constant), &mut along[6..]),
            }
            ungroup(|g| state.modal.odd[axis][g], &mut about[6..]);
        }
        let entries = match self.modal_mass {
            ModalMatrix::Diagonal(entries) => Some(entries.as_slice()),
            _ => None,
        };
        let moments = self.modal_first_moment.map(|groups| groups.as_slice());
        let [first, second, third] = &state.modal.odd;
        write_modal_columns::<T, R, N>(self.registers, [first, second, third], moments, entries, right);
        if let ModalMatrix::Dense(groups) = self.modal_mass {
            for (nu, column) in right.iter_mut().enumerate() {
                let Some((_, modal)) = column.split_first_chunk_mut::<6>() else { return };
                for (group, places) in groups.iter().zip(modal.chunks_mut(4)) {
                    let Some(entries) = group.get(nu) else { return };
                    for (place, entry) in places.iter_mut().zip(entries) {
                        *place = T::constant(*entry);
                    }
                }
            }
        }
    }
}

/// The columns of the modes. A function of slices, so that one loop serves all modes.
#[inline(always)]
fn write_modal_columns<T: Scalar, R: Registers<T>, const N: usize>(
    registers: R,
    [first, second, third]: [&[[T; 4]]; 3],
    moments: Option<&[[[T::Constant; 4]; 3]]>,
    modal_mass: Option<&[[T::Constant; 4]]>,
    columns: &mut [[T; N]],
) {
    let groups = first.iter().zip(second).zip(third);
    for (g, (((first, second), third), columns)) in groups.zip(columns.chunks_mut(4)).enumerate() {
        let moments = match moments.and_then(|moments| moments.get(g)) {
            Some(moments) => moments.map(|numbers| four::<T, R>(registers, &numbers)),
            None => [zero::<T, R>(registers); 3],
        };
        let modal_mass = match modal_mass.and_then(|modal_mass| modal_mass.get(g)) {
            Some(modal_mass) => modal_mass.map(T::constant),
            None => [T::one(); 4],
        };
        let heads =
            Register::<T, R>::transpose([moments[0], moments[1], moments[2], load::<T, R>(registers, first)]);
        for (k, column) in columns.iter_mut().enumerate().take(4) {
            let Some((top, bottom)) = column.split_first_chunk_mut::<6>() else { return };
            top[..4].copy_from_slice(&heads[k].store());
            [top[4], top[5]] = [second[k], third[k]];
            bottom.fill(T::zero());
            if let Some(entry) = bottom.get_mut(4 * g + k) {
                *entry = modal_mass[k];
            }
        }
    }
}
