//! The dense mass matrix.

use super::equations::Deformed;
use super::scalar::{Register, ungroup};
use super::{Diagonal, Four, LaneBody, Lanes, Scalar};

impl<T: Scalar, const M: usize, const G: usize, P> LaneBody<T, M, G, P> {
    /// Writes M(q), columns of N = 6 + M entries. Source: (203), body-resolved, signs corrected.
    #[inline(always)]
    pub(super) fn write_mass_matrix<const N: usize>(
        &self,
        deformed: &Deformed<T, G>,
        columns: &mut [[T; N]; N],
    ) {
        const { assert!(N == 6 + M) };
        let zero = T::ZERO;
        let (mass, [x, y, z]) = (self.mass, deformed.first_moment);
        let [xx, yy, zz, xy, xz, yz] = deformed.inertia;
        let rigid = [
            [mass, zero, zero, zero, z, -y],
            [zero, mass, zero, -z, zero, x],
            [zero, zero, mass, y, -x, zero],
            [zero, -z, y, xx, xy, xz],
            [z, zero, -x, xy, yy, yz],
            [-y, x, zero, xz, yz, zz],
        ];
        let moments = self.modal_first_moment;
        let (left, right) = columns.split_at_mut(6);
        for (axis, (column, rigid)) in left.iter_mut().zip(rigid).enumerate() {
            column[..6].copy_from_slice(&rigid);
            match (axis, moments) {
                (0..3, None) => column[6..].fill(zero),
                (0..3, Some(moments)) => {
                    ungroup(&moments.map(|group| Register::<T>::load(&group[axis])), &mut column[6..]);
                }
                _ => ungroup(&deformed.coupling[axis - 3], &mut column[6..]),
            }
        }
        for (g, columns) in right.chunks_mut(4).enumerate() {
            let [first, second, third] = [0, 1, 2].map(|axis| deformed.coupling[axis][g]);
            let moments = match moments {
                Some(moments) => moments[g].map(|numbers| Register::<T>::load(&numbers)),
                None => [Register::<T>::ZERO; 3],
            };
            let heads = Register::<T>::transpose([moments[0], moments[1], moments[2], first]);
            let (second, third) = (second.store(), third.store());
            for (k, column) in columns.iter_mut().enumerate() {
                column[6..].fill(zero);
                column[..4].copy_from_slice(&heads[k].store());
                column[4] = second[k];
                column[5] = third[k];
                if let Some(entry) = column.get_mut(6 + 4 * g + k) {
                    *entry = match self.modal_mass {
                        Diagonal::Zero => zero,
                        Diagonal::Identity => T::ONE,
                        Diagonal::Entries(entries) => entries[g][k],
                    };
                }
            }
        }
    }
}
