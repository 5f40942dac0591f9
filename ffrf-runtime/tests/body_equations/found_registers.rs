//! Loops in registers that are found when running give the bits of the same loops one number at a time, with every
//! multiply-add fused: an instruction set changes no result but by that.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use ffrf_runtime::lanes::{
    Everywhere, Factors, Four, FullTable, HalfTable, HasLanes, LaneBody, Lanes, Level, ModalFactors,
    ModalMatrix, MomentTable, Registers, Scalar,
};
use ffrf_test_kit::random::Random;

/// A number whose multiply-adds are rounded once.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fused<T>(T);

/// Such numbers side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
struct FusedLanes<T, const W: usize>([Fused<T>; W]);

macro_rules! operators {
    ($scalar:ty; $($operator:ident $method:ident)*) => {$(
        impl $operator for Fused<$scalar> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

macro_rules! lane_by_lane {
    ($scalar:ty; $($operator:ident $method:ident)*) => {$(
        impl<const W: usize> $operator for FusedLanes<$scalar, W> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|k| self.0[k].$method(other.0[k])))
            }
        }
    )*};
}

macro_rules! fused {
    ($scalar:ty, $sum:path) => {
        operators! { $scalar; Add add  Sub sub  Mul mul  Div div }
        lane_by_lane! { $scalar; Add add  Sub sub  Mul mul }

        impl Neg for Fused<$scalar> {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl AddAssign for Fused<$scalar> {
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl SubAssign for Fused<$scalar> {
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl<const W: usize> Lanes<Fused<$scalar>, W> for FusedLanes<$scalar, W> {
            fn like(self, numbers: &[Fused<$scalar>; W]) -> Self {
                Self(*numbers)
            }

            fn store(self) -> [Fused<$scalar>; W] {
                self.0
            }

            fn multiply_add(self, factor: Self, term: Self) -> Self {
                Self(std::array::from_fn(|k| self.0[k].multiply_add(factor.0[k], term.0[k])))
            }

            fn subtract_from(self, factor: Self, term: Self) -> Self {
                Self(std::array::from_fn(|k| (-self.0[k]).multiply_add(factor.0[k], term.0[k])))
            }

            fn sum(self) -> Fused<$scalar> {
                Fused($sum(&self.0.map(|lane| lane.0)))
            }
        }

        impl<const W: usize> Everywhere<Fused<$scalar>, W> for FusedLanes<$scalar, W> {
            fn load(numbers: &[Fused<$scalar>; W]) -> Self {
                Self(*numbers)
            }

            fn splat(number: Fused<$scalar>) -> Self {
                Self([number; W])
            }
        }

        impl Four<Fused<$scalar>> for FusedLanes<$scalar, 4> {
            fn transpose(rows: [Self; 4]) -> [Self; 4] {
                std::array::from_fn(|i| Self(std::array::from_fn(|j| rows[j].0[i])))
            }
        }

        impl HasLanes<4> for Fused<$scalar> {
            type Lanes = FusedLanes<$scalar, 4>;
        }

        impl HasLanes<8> for Fused<$scalar> {
            type Lanes = FusedLanes<$scalar, 8>;
        }

        impl Scalar for Fused<$scalar> {
            type Constant = $scalar;

            fn constant(constant: $scalar) -> Self {
                Self(constant)
            }

            fn zero() -> Self {
                Self(0.0)
            }

            fn half() -> Self {
                Self(0.5)
            }

            fn one() -> Self {
                Self(1.0)
            }

            fn two() -> Self {
                Self(2.0)
            }

            fn multiply_add(self, factor: Self, term: Self) -> Self {
                Self(self.0.mul_add(factor.0, term.0))
            }
        }
    };
}

/// Lane k and lane k + W/2 first.
fn halving(lanes: &[f64]) -> f64 {
    let (low, high) = lanes.split_at(lanes.len() / 2);
    match (low, high) {
        ([low], [high]) => low + high,
        _ => halving(&low.iter().zip(high).map(|(low, high)| low + high).collect::<Vec<_>>()),
    }
}

fn one_by_one(lanes: &[f32]) -> f32 {
    lanes.iter().sum()
}

fused!(f64, halving);
fused!(f32, one_by_one);

/// A body of `M` modes whose numbers are no body's, with every term.
fn body<C: Copy + 'static, const M: usize, const G: usize, P>(
    number: &mut impl FnMut() -> C,
    moments: P,
) -> LaneBody<'static, C, M, G, P> {
    fn rows<C: Copy + 'static, const K: usize, const G: usize>(
        number: &mut impl FnMut() -> C,
    ) -> &'static [[[C; 4]; K]; G] {
        Box::leak(Box::new(std::array::from_fn(|_| {
            std::array::from_fn(|_| std::array::from_fn(|_| number()))
        })))
    }
    let [stiffness] = rows::<C, G, 1>(number);
    let [pivots] = rows::<C, G, 1>(number);
    LaneBody {
        registers: ffrf_runtime::lanes::Compiled,
        mass: number(),
        first_moment: Some([number(), number(), number()]),
        modal_first_moment: Some(rows(number)),
        inertia: std::array::from_fn(|_| number()),
        translation_factors: Factors {
            inverse_pivots: [number(), number(), number()],
            lower: Some([number(), number(), number()]),
        },
        eliminated_first_moment: Some(rows(number)),
        position_mode_even: Some(rows(number)),
        position_mode_odd: Some(rows(number)),
        trace: ModalMatrix::Dense(rows(number)),
        modal_mass: ModalMatrix::Dense(rows(number)),
        modal_factors: ModalFactors::Triangular { inverse_pivots: pivots, lower: rows(number) },
        stiffness: ModalMatrix::Diagonal(stiffness),
        damping: ModalMatrix::Dense(rows(number)),
        moments,
        second_order_odd: Some(Box::leak(Box::new(std::array::from_fn(|_| {
            std::array::from_fn(|_| std::array::from_fn(|_| std::array::from_fn(|_| number())))
        })))),
    }
}

/// A state of motion and a force.
struct Point<T, const M: usize, const N: usize> {
    q: [T; M],
    q_dot: [T; M],
    omega: [T; 3],
    velocity: [T; 3],
    force: [T; N],
}

/// Everything that the loops compute, one number after another.
fn results<T, R, P, const M: usize, const N: usize, const G: usize>(
    body: &LaneBody<'_, T::Constant, M, G, P, R>,
    point: &Point<T, M, N>,
) -> Vec<T>
where
    T: Scalar,
    R: Registers<T>,
    P: MomentTable<T, M, G, R>,
{
    let Point { q, q_dot, omega, velocity, force } = point;
    let state = body.state(q, *omega, q_dot);
    let (mass_matrix, quadratic_velocity, accelerations) =
        body.equations_of_motion::<T, N>(&state, q, q_dot, force);
    let mut results = mass_matrix.as_flattened().to_vec();
    results.extend(quadratic_velocity);
    results.extend(accelerations);
    results.push(body.kinetic_energy(&state, velocity, omega, q_dot));
    results.extend(body.angular_momentum(&state, velocity, omega));
    results
}

macro_rules! agree {
    ($($name:ident: $scalar:ty, $modes:literal $size:literal $groups:literal $table:expr;)*) => {$(
        #[test]
        fn $name() {
            let Some(registers) = Level::new().as_avx2() else {
                eprintln!("SKIPPED: this processor has no AVX2 to be found");
                return;
            };
            let mut random = Random::new(11);
            let mut number = || random.number() as $scalar;
            let table = $table(&mut number);
            let body = body::<$scalar, $modes, $groups, _>(&mut number, &table);
            for _ in 0..20 {
                let point = Point::<$scalar, $modes, $size> {
                    q: std::array::from_fn(|_| number()),
                    q_dot: std::array::from_fn(|_| number()),
                    omega: std::array::from_fn(|_| number()),
                    velocity: std::array::from_fn(|_| number()),
                    force: std::array::from_fn(|_| number()),
                };
                let fused = Point {
                    q: point.q.map(Fused),
                    q_dot: point.q_dot.map(Fused),
                    omega: point.omega.map(Fused),
                    velocity: point.velocity.map(Fused),
                    force: point.force.map(Fused),
                };
                let found = results(&body.on(registers), &point);
                let expected = results(&body, &fused);
                if let Some(registers) = Level::new().as_avx512() {
                    assert_eq!(results(&body.on(registers), &point), found);
                }
                for (found, expected) in found.iter().zip(&expected) {
                    assert!(found.is_finite());
                    assert_eq!(found.to_bits(), expected.0.to_bits(), "{found} and {}", expected.0);
                }
                assert_eq!(found.len(), expected.len());
            }
        }
    )*};
}

/// All moments of `M` modes.
fn whole<C: Copy, const M: usize, const PAIRS: usize, const SINGLE: usize>(
    number: &mut impl FnMut() -> C,
) -> FullTable<C, M, PAIRS, SINGLE> {
    fn lanes<C, const M: usize, const W: usize>(number: &mut impl FnMut() -> C) -> [[[C; W]; 8]; M] {
        std::array::from_fn(|_| std::array::from_fn(|_| std::array::from_fn(|_| number())))
    }
    FullTable {
        eights: std::array::from_fn(|_| lanes(number)),
        fours: std::array::from_fn(|_| lanes(number)),
    }
}

/// Half of the moments, in blocks of `W` x `W` modes.
fn half<C: Copy, const W: usize, const H: usize, const TILES: usize>(
    number: &mut impl FnMut() -> C,
) -> HalfTable<C, W, H, TILES> {
    fn tile<C, const W: usize>(number: &mut impl FnMut() -> C) -> [[C; W]; W] {
        std::array::from_fn(|_| std::array::from_fn(|_| number()))
    }
    HalfTable {
        diagonal: std::array::from_fn(|_| std::array::from_fn(|_| tile(number))),
        below: std::array::from_fn(|_| tile(number)),
    }
}

agree! {
    eight_modes: f64, 8 14 2 whole::<_, 8, 1, 0>;
    eleven_modes: f64, 11 17 3 whole::<_, 11, 1, 1>;
    twenty_modes: f64, 20 26 5 half::<_, 4, 5, 80>;
    eight_modes_in_single_precision: f32, 8 14 2 whole::<_, 8, 1, 0>;
    eleven_modes_in_single_precision: f32, 11 17 3 whole::<_, 11, 1, 1>;
    twenty_modes_in_single_precision: f32, 20 26 6 half::<_, 8, 3, 24>;
}
