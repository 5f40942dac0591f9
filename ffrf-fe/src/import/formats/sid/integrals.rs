//! Inertia invariants and geometric stiffness from the matrices. The definitions stand in [`crate::export::sid`].

use ffrf_model::{GeometricStiffness, Inertia, Matrix3, SecondOrderTerms, Vector3};

use crate::export::sid::{IN_J, IN_OE};

/// What the matrices of a file say, each by rows; those of first order by mode, then by rows.
#[derive(Debug, Default)]
pub(super) struct Matrices {
    pub modes: usize,
    pub mass: f64,
    pub first_moment: Vec<f64>,
    /// M1 of mdCM, if it is given.
    pub modal_first_moment: Option<Vec<f64>>,
    /// J as 6 numbers, and the change with each mode.
    pub inertia: [f64; 6],
    pub inertia_by_mode: Option<Vec<[f64; 6]>>,
    pub ct: Vec<f64>,
    pub ct_by_mode: Option<Vec<f64>>,
    pub cr: Vec<f64>,
    pub cr_by_mode: Option<Vec<f64>>,
    pub me: Vec<f64>,
    pub gr: Option<Vec<f64>>,
    pub gr_by_mode: Option<Vec<f64>>,
    pub ge: Option<Vec<f64>>,
    pub oe: Option<Vec<f64>>,
    pub oe_by_mode: Option<Vec<f64>>,
}

/// What a body holds of them.
pub(super) struct Integrals {
    pub inertia: Inertia,
    pub geometric_stiffness: Option<GeometricStiffness>,
    pub second_order_terms: SecondOrderTerms,
    /// Integrals that a file gives twice: their names, and how far they differ, relative to the largest.
    pub copies: Vec<(&'static str, f64)>,
}

/// Differences of numbers that files print to 12 digits, relative to the largest of them: below is nothing.
const NOISE: f64 = 1e-9;

impl Matrices {
    /// The invariants.
    pub fn integrals(&self) -> Integrals {
        let modes = self.modes;
        let list = || 0..modes;
        let pairs = || list().flat_map(move |mu| list().map(move |nu| (mu, nu)));
        let of_first: Vec<Matrix3> = list().map(|mu| self.position_mode_moment(mu)).collect();
        // Ct M1: -Γ of uniform loads. Cr M1: odd parts, antisymmetric in the modes of T and symmetric of Γ.
        let uniform = by_pair(modes, |mu, nu| {
            let at = |mu: usize, nu: usize| three(self.ct_by_mode.as_deref(), (nu * modes + mu) * 3);
            combined(at(mu, nu), at(nu, mu), [-0.5, -0.5])
        });
        let cr = |mu: usize, nu: usize| three(self.cr_by_mode.as_deref(), (nu * modes + mu) * 3);
        let ge = |mu: usize, nu: usize| three(self.ge.as_deref(), mu * 3 * modes + 3 * nu);
        let odd_of_inertia = by_pair(modes, |mu, nu| match self.cr_by_mode {
            Some(_) => combined(cr(mu, nu), cr(nu, mu), [0.5, -0.5]),
            None => combined(ge(mu, nu), ge(nu, mu), [0.25, -0.25]),
        });
        let mut odd_of_stiffness = by_pair(modes, |mu, nu| combined(cr(mu, nu), cr(nu, mu), [-0.5, -0.5]));
        let largest_odd = self.cr_by_mode.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        if largest(odd_of_stiffness.iter().flatten().flatten()) <= NOISE * largest_odd {
            odd_of_stiffness.iter_mut().flatten().for_each(|odd| *odd = [0.0; 3]);
        }

        let modal_mass = |mu: usize, nu: usize| self.me[mu * modes + nu];
        let largest_mass = largest(self.me.iter());
        // Symmetric part of T - Γ from Oe M1, of T from Gr M1.
        let sum = self.oe_by_mode.as_ref().map(|oe| {
            by_pair(modes, |mu, nu| {
                let of = |mu: usize, nu: usize| -> [f64; 6] {
                    std::array::from_fn(|k| oe[(nu * modes + mu) * 6 + k])
                };
                moment(&average(of_oe(of(mu, nu)), of_oe(of(nu, mu))))
            })
        });
        let alone = self.gr_by_mode.as_ref().map(|gr| {
            by_pair(modes, |mu, nu| {
                let of = |mu: usize, nu: usize| -> Matrix3 {
                    let entry = |i: usize, j: usize| gr[(nu * 3 + i) * 3 * modes + 3 * mu + j];
                    std::array::from_fn(|i| std::array::from_fn(|j| 0.25 * (entry(i, j) + entry(j, i))))
                };
                moment(&average(of(mu, nu), of(nu, mu)))
            })
        });
        let zero = || vec![vec![[[0.0; 3]; 3]; modes]; modes];
        let stiffened =
            [&uniform, &odd_of_stiffness].iter().any(|all| largest(all.iter().flatten().flatten()) > 0.0);
        let lacking = |even: &Matrix3, mu: usize, nu: usize| (modal_mass(mu, nu) - trace(even)) / 3.0;
        let (mut even, even_of_stiffness, terms) = match (alone, sum) {
            (Some(alone), Some(sum)) => {
                let mut stiffness = by_pair(modes, |mu, nu| plus(&alone[mu][nu], &sum[mu][nu], -1.0));
                if largest(stiffness.iter().flatten().flatten().flatten()) <= NOISE * largest_mass {
                    stiffness = zero();
                }
                (alone, stiffness, SecondOrderTerms::Known)
            }
            (Some(alone), None) => (alone, zero(), SecondOrderTerms::Known),
            (None, Some(sum)) => {
                let most =
                    pairs().map(|(mu, nu)| 3.0 * lacking(&sum[mu][nu], mu, nu).abs()).fold(0.0, f64::max);
                if !stiffened && most <= NOISE * largest_mass {
                    (sum, zero(), SecondOrderTerms::Known)
                } else {
                    let stiffness = by_pair(modes, |mu, nu| unit(lacking(&sum[mu][nu], mu, nu)));
                    (sum, stiffness, SecondOrderTerms::Together)
                }
            }
            (None, None) => (zero(), zero(), SecondOrderTerms::Unknown),
        };
        // The trace of T is the modal mass.
        for (mu, nu) in pairs() {
            even[mu][nu] = plus(&even[mu][nu], &unit(lacking(&even[mu][nu], mu, nu)), 1.0);
        }
        let linear =
            by_pair(modes, |mu, nu| plus(&even_of_stiffness[mu][nu], &axial(odd_of_stiffness[mu][nu]), 1.0));
        let is_stiff = stiffened || largest(linear.iter().flatten().flatten().flatten()) > 0.0;
        Integrals {
            copies: self.copies(&of_first),
            inertia: Inertia {
                mass: self.mass,
                first_moment: three(Some(&self.first_moment), 0),
                modal_first_moment: list().map(|mu| three(Some(&self.ct), 3 * mu)).collect(),
                second_moment: moment(&of_six(self.inertia)),
                position_mode_moment: of_first,
                // T_μν is the transpose of T_νμ, whose odd part Cr M1 holds at (mu, nu).
                mode_mode_moment: by_pair(modes, |mu, nu| {
                    plus(&even[mu][nu], &axial(odd_of_inertia[nu][mu]), 1.0)
                }),
            },
            geometric_stiffness: is_stiff.then_some(GeometricStiffness {
                uniform_load: uniform,
                linear_load: linear,
                marker_loads: Vec::new(),
            }),
            second_order_terms: terms,
        }
    }

    /// T_μ: its symmetric part from J, else from Gr; its odd part from Cr.
    fn position_mode_moment(&self, mu: usize) -> Matrix3 {
        let even = match &self.inertia_by_mode {
            Some(inertia) => of_six(inertia[mu].map(|entry| 0.5 * entry)),
            None => self.even_of_gr(mu),
        };
        plus(&moment(&even), &axial(three(Some(&self.cr), 3 * mu)), 1.0)
    }

    /// Symmetric part of Θ_μ from Gr.
    fn even_of_gr(&self, mu: usize) -> Matrix3 {
        std::array::from_fn(|i| std::array::from_fn(|j| 0.25 * (self.of_gr(mu, i, j) + self.of_gr(mu, j, i))))
    }

    fn of_gr(&self, mu: usize, i: usize, j: usize) -> f64 {
        self.gr.as_ref().map_or(0.0, |gr| gr[i * 3 * self.modes + 3 * mu + j])
    }

    /// Compares what a file gives more than once.
    fn copies(&self, of_first: &[Matrix3]) -> Vec<(&'static str, f64)> {
        let modes = self.modes;
        let mut copies = Vec::new();
        let mut compare = |names: &'static str, pairs: Vec<(f64, f64)>| {
            let most = pairs.iter().fold(0.0_f64, |most, (a, b)| most.max(a.abs()).max(b.abs()));
            let difference = pairs.iter().fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            copies.push((names, if most > 0.0 { difference / most } else { 0.0 }));
        };
        if let Some(moments) = &self.modal_first_moment {
            compare("mdCM and Ct", moments.iter().copied().zip(self.ct.iter().copied()).collect());
        }
        // Θ_μ of what was taken.
        let theta: Vec<Matrix3> = of_first
            .iter()
            .map(|t| std::array::from_fn(|i| std::array::from_fn(|j| unit(trace(t))[i][j] - t[j][i])))
            .collect();
        if self.gr.is_some() {
            let all = |mu: usize| (0..9).map(move |k| (k / 3, k % 3)).map(move |(i, j)| (mu, i, j));
            let pairs =
                (0..modes).flat_map(all).map(|(mu, i, j)| (0.5 * self.of_gr(mu, i, j), theta[mu][i][j]));
            compare("Gr and J, Cr", pairs.collect());
        }
        if let Some(oe) = &self.oe {
            let expected = |mu: usize, k: usize| {
                let (i, j) = IN_OE[k];
                -if i == j { theta[mu][i][i] } else { theta[mu][i][j] + theta[mu][j][i] }
            };
            let pairs = (0..6 * modes).map(|at| (oe[at], expected(at / 6, at % 6)));
            compare("Oe and J", pairs.collect());
        }
        if let (Some(ge), Some(cr)) = (&self.ge, &self.cr_by_mode) {
            let pairs = (0..modes * modes).flat_map(|at| {
                let (mu, nu) = (at / modes, at % modes);
                (0..3).map(move |k| {
                    let odd = 0.5 * (cr[(nu * modes + mu) * 3 + k] - cr[(mu * modes + nu) * 3 + k]);
                    (0.5 * ge[mu * 3 * modes + 3 * nu + k], odd)
                })
            });
            compare("Ge and Cr", pairs.collect());
        }
        copies
    }
}

fn by_pair<T>(modes: usize, of: impl Fn(usize, usize) -> T) -> Vec<Vec<T>> {
    (0..modes).map(|mu| (0..modes).map(|nu| of(mu, nu)).collect()).collect()
}

fn three(list: Option<&[f64]>, at: usize) -> Vector3 {
    std::array::from_fn(|k| list.and_then(|list| list.get(at + k)).copied().unwrap_or(0.0))
}

fn combined(a: Vector3, b: Vector3, factors: [f64; 2]) -> Vector3 {
    std::array::from_fn(|k| factors[0] * a[k] + factors[1] * b[k])
}

fn largest<'a>(numbers: impl Iterator<Item = &'a f64>) -> f64 {
    numbers.fold(0.0, |most, number| most.max(number.abs()))
}

fn trace(matrix: &Matrix3) -> f64 {
    matrix[0][0] + matrix[1][1] + matrix[2][2]
}

fn unit(factor: f64) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { factor } else { 0.0 }))
}

fn plus(a: &Matrix3, b: &Matrix3, factor: f64) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + factor * b[i][j]))
}

fn average(a: Matrix3, b: Matrix3) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (a[i][j] + b[i][j])))
}

/// The symmetric matrix of six numbers in the order of J.
fn of_six(six: [f64; 6]) -> Matrix3 {
    let mut matrix = [[0.0; 3]; 3];
    for ((i, j), entry) in IN_J.into_iter().zip(six) {
        matrix[i][j] = entry;
        matrix[j][i] = entry;
    }
    matrix
}

/// Symmetric part of Θ of six numbers in the order of Oe, which are those of -ω·Θω.
fn of_oe(six: [f64; 6]) -> Matrix3 {
    let mut matrix = [[0.0; 3]; 3];
    for ((i, j), entry) in IN_OE.into_iter().zip(six) {
        let entry = if i == j { -entry } else { -0.5 * entry };
        matrix[i][j] = entry;
        matrix[j][i] = entry;
    }
    matrix
}

/// The symmetric T of a symmetric Θ = tr(T) 1 - T.
fn moment(theta: &Matrix3) -> Matrix3 {
    let half = 0.5 * trace(theta);
    std::array::from_fn(|i| std::array::from_fn(|j| unit(half)[i][j] - 0.5 * (theta[i][j] + theta[j][i])))
}

/// The antisymmetric T of ϑ = ε_ijk T^{ij} e_k.
fn axial(theta: Vector3) -> Matrix3 {
    let [x, y, z] = theta.map(|entry| 0.5 * entry);
    [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]
}
