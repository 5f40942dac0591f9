//! Standard input data (SID) of flexible bodies, the text form that FEMBS, Dymola, Simpack and others read.
//!
//! Source: Wallrapp, Standardization of flexible body modeling in multibody system codes, Mech. Struct. Mach. 22 (1994) 283-304;
//! Schwertassek and Wallrapp, Dynamik flexibler Mehrkörpersysteme (1999), table 6.9. Every matrix is M(q) = M0 + q_l M1_l, an entry of
//! M1 is `m1(row, mode, column)`. With x the positions, φ the modes, Γ the stress stiffness of unit loads, Θ and ϑ of a moment T as in
//! `docs/theory/equations.md`, and mode μ the row where there is one:
//!
//! | matrix | size | M0 | M1_ν |
//! |---|---|---|---|
//! | mdCM | 3 x 1 | ∫ρ x | ∫ρ φ_ν |
//! | J | 6: xx, yy, zz, xy, xz, yz | Θ | Θ_ν + Θ_νᵀ |
//! | Ct | M x 3 | ∫ρ φ_μ | -Γ_μν of uniform loads |
//! | Cr | M x 3 | ϑ_μ | ϑ_νμ - ϑ(Γ_μν) |
//! | Me | M x M | tr T_μν | |
//! | Gr | 3 x 3M, block μ | 2 Θ_μ | 2 Θ_νμ |
//! | Ge | M x 3M, block ν | 2 ϑ_νμ | |
//! | Oe | M x 6: xx, yy, zz, xy, yz, xz | those of -ω·Θ_μ ω | those of -ω·(Θ_νμ - Θ(Γ_μν)) ω |
//! | Ke, De | M x M | K_ff, D_ff | |

use std::fmt::Write as _;

use ffrf_model::{Inertia, Matrix3, ReducedBody, Vector3};

/// Axes of the six numbers of J.
pub(crate) const IN_J: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
/// Axes of the six numbers of Oe, which stand beside ω_x², ω_y², ω_z², ω_x ω_y, ω_y ω_z, ω_x ω_z.
pub(crate) const IN_OE: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];

/// The file of a body: its markers are the nodes; every matrix is written to the order that the body knows.
///
/// A body that does not hold its terms of second order in q gets no term of first order in Gr, and in Oe only what it holds.
/// Stress markers are not written.
pub fn sid_text(body: &ReducedBody) -> String {
    let modes = body.mode_count();
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{:5}{:5}    :No. nodes, No. modes:ffrf {}",
        body.markers.len(),
        modes,
        env!("CARGO_PKG_VERSION")
    );
    text += " part\n      new modal                                 =\n           refmod\n";
    key(&mut text, 16, "mass", &fortran(body.inertia.mass));
    key(&mut text, 16, "nelastq", &format!(" {modes}"));
    for (number, mode) in (1..).zip(&body.modes) {
        let name = match mode.frequency_hz {
            Some(frequency) => format!(" Eigen Mode {number:4} : {frequency} Hz"),
            None => format!(" Mode {number:4}"),
        };
        key(&mut text, 16, &format!("ielastq ({number:4})"), &name);
    }
    text += "           end refmod\n           frame\n";
    for (number, marker) in body.markers.iter().enumerate() {
        let name = match marker.name.strip_prefix('N') {
            // As such a node is called when it is read.
            Some(id) if !id.is_empty() && id.bytes().all(|byte| byte.is_ascii_digit()) => id,
            _ => &marker.name,
        };
        node(&mut text, name, body, number);
    }
    text += "           end frame\n";
    inertia(&mut text, body);
    let zero = Matrix::new("ksigma", modes, 1, modes);
    zero.write(&mut text, OF_BODY);
    for (name, list) in [("Ke", &body.stiffness), ("De", &body.damping)] {
        let mut matrix = Matrix::new(name, modes, modes, modes);
        for (row, entries) in list.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                matrix.set(row, column, *entry);
            }
        }
        matrix.write(&mut text, OF_BODY);
    }
    text += "      end modal\n end part\n";
    text
}

/// Columns before the names of the matrices of the body, and of a node.
const OF_BODY: usize = 11;
const OF_NODE: usize = 21;

fn node(text: &mut String, name: &str, body: &ReducedBody, number: usize) {
    let Some(marker) = body.markers.get(number) else { return };
    let modes = body.mode_count();
    key(text, 16, "new node", &format!(" {name}"));
    key(text, 21, "rframe", " body ref");
    let mut origin = Matrix::new("origin", 3, 1, modes).of_first_order();
    let (mut phi, mut psi) = (Matrix::new("phi", 3, modes, modes), Matrix::new("psi", 3, modes, modes));
    let mut frame = Matrix::new("AP", 3, 3, modes).of_first_order();
    for k in 0..3 {
        origin.set(k, 0, marker.position[k]);
        frame.set(k, k, 1.0);
        for mu in 0..modes {
            origin.set_first(k, mu, 0, marker.translation[mu][k]);
            phi.set(k, mu, marker.translation[mu][k]);
            psi.set(k, mu, marker.rotation[mu][k]);
            // The cross product with the rotation.
            let [next, after] = [(k + 1) % 3, (k + 2) % 3];
            frame.set_first(after, mu, next, marker.rotation[mu][k]);
            frame.set_first(next, mu, after, -marker.rotation[mu][k]);
        }
    }
    [origin, phi, psi, frame].iter().for_each(|matrix| matrix.write(text, OF_NODE));
    text.push_str("                end node\n");
}

fn inertia(text: &mut String, body: &ReducedBody) {
    let (inertia, modes) = (&body.inertia, body.mode_count());
    let Inertia { position_mode_moment, mode_mode_moment, .. } = inertia;
    let is_known = body.second_order_terms.is_known();
    let holds_sum = body.second_order_terms != ffrf_model::SecondOrderTerms::Unknown;
    let mut centre = Matrix::new("mdCM", 3, 1, modes).of_first_order();
    let mut tensor = Matrix::new("J", 6, 1, modes).of_first_order();
    let mut ct = Matrix::new("Ct", modes, 3, modes);
    let mut cr = Matrix::new("Cr", modes, 3, modes).of_first_order();
    let mut me = Matrix::new("Me", modes, modes, modes);
    let mut gr = Matrix::new("Gr", 3, 3 * modes, modes);
    let mut ge = Matrix::new("Ge", modes, 3 * modes, modes);
    let mut oe = Matrix::new("Oe", modes, 6, modes);
    gr.order = usize::from(is_known);
    oe.order = usize::from(holds_sum);
    ct.order = usize::from(body.geometric_stiffness.is_some());
    let theta = theta_of(&inertia.second_moment);
    for (k, (i, j)) in IN_J.into_iter().enumerate() {
        tensor.set(k, 0, theta[i][j]);
    }
    for k in 0..3 {
        centre.set(k, 0, inertia.first_moment[k]);
    }
    for mu in 0..modes {
        let (theta, odd) = (theta_of(&position_mode_moment[mu]), axial(&position_mode_moment[mu]));
        for k in 0..3 {
            centre.set_first(k, mu, 0, inertia.modal_first_moment[mu][k]);
            ct.set(mu, k, inertia.modal_first_moment[mu][k]);
            cr.set(mu, k, odd[k]);
            for j in 0..3 {
                gr.set(k, 3 * mu + j, 2.0 * theta[k][j]);
            }
        }
        for k in 0..6 {
            let (i, j) = IN_J[k];
            tensor.set_first(k, mu, 0, theta[i][j] + theta[j][i]);
            oe.set(mu, k, centrifugal(&theta, k));
        }
        for nu in 0..modes {
            let moment = &mode_mode_moment[nu][mu];
            let (uniform, linear) = match &body.geometric_stiffness {
                Some(stiffness) => (stiffness.uniform_load[mu][nu], stiffness.linear_load[mu][nu]),
                None => ([0.0; 3], [[0.0; 3]; 3]),
            };
            let (odd, odd_of_stiffness) = (axial(moment), axial(&linear));
            let of_both =
                theta_of(&std::array::from_fn(|i| std::array::from_fn(|j| moment[i][j] - linear[i][j])));
            let theta = theta_of(moment);
            me.set(mu, nu, moment[0][0] + moment[1][1] + moment[2][2]);
            for k in 0..3 {
                ct.set_first(mu, nu, k, -uniform[k]);
                cr.set_first(mu, nu, k, odd[k] - odd_of_stiffness[k]);
                ge.set(mu, 3 * nu + k, 2.0 * odd[k]);
                for j in 0..3 {
                    gr.set_first(k, nu, 3 * mu + j, 2.0 * theta[k][j]);
                }
            }
            for k in 0..6 {
                oe.set_first(mu, nu, k, centrifugal(&of_both, k));
            }
        }
    }
    [centre, tensor, ct, cr, me, gr, ge, oe].iter().for_each(|matrix| matrix.write(text, OF_BODY));
}

/// Θ = tr(T) 1 - Tᵀ.
fn theta_of(moment: &Matrix3) -> Matrix3 {
    let trace = moment[0][0] + moment[1][1] + moment[2][2];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { trace - moment[i][i] } else { -moment[j][i] })
    })
}

/// ϑ = ε_ijk T^{ij} e_k.
fn axial(moment: &Matrix3) -> Vector3 {
    [moment[1][2] - moment[2][1], moment[2][0] - moment[0][2], moment[0][1] - moment[1][0]]
}

/// Number `k` of -ω·Θω in the order of Oe.
fn centrifugal(theta: &Matrix3, k: usize) -> f64 {
    let (i, j) = IN_OE[k];
    -if i == j { theta[i][i] } else { theta[i][j] + theta[j][i] }
}

/// A matrix to be written, of which the zeros are left out.
struct Matrix {
    name: &'static str,
    order: usize,
    rows: usize,
    columns: usize,
    modes: usize,
    zeroth: Vec<(usize, usize, f64)>,
    first: Vec<(usize, usize, usize, f64)>,
}

impl Matrix {
    fn new(name: &'static str, rows: usize, columns: usize, modes: usize) -> Self {
        Self { name, order: 0, rows, columns, modes, zeroth: Vec::new(), first: Vec::new() }
    }

    fn of_first_order(mut self) -> Self {
        self.order = 1;
        self
    }

    fn set(&mut self, row: usize, column: usize, value: f64) {
        if value != 0.0 {
            self.zeroth.push((row + 1, column + 1, value));
        }
    }

    fn set_first(&mut self, row: usize, mode: usize, column: usize, value: f64) {
        if value != 0.0 && self.order > 0 {
            self.first.push((row + 1, mode + 1, column + 1, value));
        }
    }

    fn write(&self, text: &mut String, indent: usize) {
        let structure = if self.zeroth.is_empty() && self.first.is_empty() { 0 } else { 3 };
        let _ = writeln!(text, "{:indent$}{}", "", self.name);
        for (name, value) in [
            ("order", self.order),
            ("nrow", self.rows),
            ("ncol", self.columns),
            ("nq", self.modes),
            ("nqn", 0),
            ("structure", structure),
        ] {
            key(text, 26, name, &format!(" {value:4}"));
        }
        for (row, column, value) in &self.zeroth {
            key(text, 26, &format!("m0({row:2},{column:2})"), &fortran(*value));
        }
        for (row, mode, column, value) in &self.first {
            key(text, 26, &format!("m1({row:2},{mode:2},{column:2})"), &fortran(*value));
        }
        let _ = writeln!(text, "{:indent$}end {}", "", self.name);
    }
}

/// `key = value`, the sign in a column of its own.
fn key(text: &mut String, indent: usize, key: &str, value: &str) {
    let width = 48_usize.saturating_sub(indent);
    let _ = writeln!(text, "{:indent$}{key:width$}={value}", "");
}

/// A number with all its digits and the exponent letter of Fortran, as in `-1.2500000000000000D+01`.
fn fortran(number: f64) -> String {
    let text = format!("{number:.16e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}{mantissa}D{sign}{:02}", if number < 0.0 { "" } else { " " }, exponent.abs())
}
