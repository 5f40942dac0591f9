//! The loops over lanes of the runtime, in either precision.

use ffrf::generated_support::lanes::{LaneBody, MomentTable, State};
use ffrf_codegen::lanes::{LaneTables, MomentTables};

use crate::equations::{Equations, Point};
use crate::real::Real;
use ffrf_host::kernels::Bodies;

/// The loops for these tables: numbers of groups that the suite uses, in the forms in which moments are stored.
pub fn of<T: Real>(tables: &LaneTables) -> Box<dyn Equations<T>> {
    let bodies = Bodies { zero: T::nearest(0.0), constant: T::nearest };
    macro_rules! loops {
        ($modes:literal, $size:literal, $groups:literal, $moments:expr) => {
            Box::new(Loops::<T, $modes, $size, $groups, _> {
                modes: tables.modes,
                body: bodies.body(tables, $moments),
            })
        };
    }
    match (tables.groups, &tables.moments) {
        (1, MomentTables::Whole { .. }) => loops!(4, 10, 1, bodies.whole::<f64, 4, 0, 1>(tables)),
        (2, MomentTables::Whole { .. }) => loops!(8, 14, 2, bodies.whole::<f64, 8, 1, 0>(tables)),
        (3, MomentTables::Whole { .. }) => loops!(12, 18, 3, bodies.whole::<f64, 12, 1, 1>(tables)),
        (4, MomentTables::Whole { .. }) => loops!(16, 22, 4, bodies.whole::<f64, 16, 2, 0>(tables)),
        (8, MomentTables::Half { diagonal, .. }) if diagonal.shape()[2] == 4 => {
            loops!(32, 38, 8, bodies.half::<f64, 4, 8, 224>(tables))
        }
        (8, MomentTables::Half { .. }) => loops!(32, 38, 8, bodies.half::<f64, 8, 4, 48>(tables)),
        (16, MomentTables::Half { diagonal, .. }) if diagonal.shape()[2] == 4 => {
            loops!(64, 70, 16, bodies.half::<f64, 4, 16, 960>(tables))
        }
        (16, MomentTables::Half { .. }) => loops!(64, 70, 16, bodies.half::<f64, 8, 8, 224>(tables)),
        (groups, _) => panic!("{groups} groups are not compiled in"),
    }
}

struct Loops<T: Real, const M: usize, const N: usize, const G: usize, P: 'static> {
    modes: usize,
    body: LaneBody<'static, T, M, G, P>,
}

/// The numbers, padded with zero.
fn padded<T: Real, const K: usize>(numbers: &[T]) -> [T; K] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(T::nearest(0.0)))
}

impl<T: Real, const M: usize, const N: usize, const G: usize, P: MomentTable<T, M, G>> Loops<T, M, N, G, P> {
    fn state(&self, point: &Point<T>) -> State<T, G> {
        self.body.state(&padded(&point.q), point.omega, &padded(&point.q_dot))
    }

    fn without_padding(&self, numbers: [T; N]) -> Vec<T> {
        numbers.into_iter().take(6 + self.modes).collect()
    }
}

impl<T: Real, const M: usize, const N: usize, const G: usize, P: MomentTable<T, M, G>> Equations<T>
    for Loops<T, M, N, G, P>
{
    fn mass_matrix(&self, point: &Point<T>) -> Vec<T> {
        let columns: [[T; N]; N] = self.body.mass_matrix(&self.state(point));
        columns.into_iter().take(6 + self.modes).flat_map(|column| self.without_padding(column)).collect()
    }

    fn quadratic_velocity(&self, point: &Point<T>) -> Vec<T> {
        self.without_padding(self.body.quadratic_velocity(&self.state(point)))
    }

    fn accelerations(&self, point: &Point<T>, force: &[T]) -> Vec<T> {
        let (q, q_dot, force) = (padded(&point.q), padded(&point.q_dot), padded(force));
        self.without_padding(self.body.forward_dynamics(&self.state(point), &q, &q_dot, &force))
    }

    fn accelerations_with_equations(&self, point: &Point<T>, force: &[T]) -> Vec<T> {
        let (q, q_dot, force) = (padded(&point.q), padded(&point.q_dot), padded(force));
        let (_, _, accelerations) =
            self.body.equations_of_motion::<T, N>(&self.state(point), &q, &q_dot, &force);
        self.without_padding(accelerations)
    }
}
