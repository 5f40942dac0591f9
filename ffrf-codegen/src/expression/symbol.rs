//! Symbols: the inputs of an expression, named by what they are.

/// An input of an expression. Indices count from 0; `mu`, `nu` number modes, `i`, `j` axes x, y, z.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Symbol {
    /// Modal coordinate q_μ.
    Coordinate(usize),
    /// Rate of a modal coordinate, q̇_μ.
    Rate(usize),
    /// Angular velocity of the body frame ω_i, body-resolved. Units: rad/s.
    AngularVelocity(usize),
    /// Velocity of the frame origin v_i, body-resolved. Units: m/s.
    Velocity(usize),
    /// Generalised force: 0..3 force, 3..6 moment, then modal forces.
    Force(usize),
    /// Acceleration, numbered as the generalised force.
    Acceleration(usize),
    /// Uniform gravity g_i, body-resolved. Units: m/s^2.
    Gravity(usize),
    /// Mass m.
    Mass,
    /// First moment (m a)_i.
    FirstMoment(usize),
    /// Modal first moment (m b_μ)_i.
    ModalFirstMoment(usize, usize),
    /// Second moment T^{ij}, i <= j.
    SecondMoment(usize, usize),
    /// Position-mode moment T_μ^{ij}.
    PositionModeMoment(usize, usize, usize),
    /// Mode-mode moment T_μν^{ij}, μ <= ν (and i <= j where μ = ν).
    ModeModeMoment(usize, usize, usize, usize),
    /// Modal mass Θ_ff,μν, μ <= ν.
    ModalMass(usize, usize),
    /// Modal stiffness K_ff,μν, μ <= ν.
    Stiffness(usize, usize),
    /// Modal damping D_ff,μν, μ <= ν.
    Damping(usize, usize),
    /// A value computed elsewhere: number `1` of the group `0`.
    Intermediate(&'static str, usize),
}

impl Symbol {
    /// Whether the symbol is an invariant of the body, not a part of its state.
    pub fn is_parameter(self) -> bool {
        matches!(
            self,
            Self::Mass
                | Self::FirstMoment(..)
                | Self::ModalFirstMoment(..)
                | Self::SecondMoment(..)
                | Self::PositionModeMoment(..)
                | Self::ModeModeMoment(..)
                | Self::ModalMass(..)
                | Self::Stiffness(..)
                | Self::Damping(..)
        )
    }
}

/// Names of the three axes.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

impl core::fmt::Display for Symbol {
    /// A name that is a Rust identifier, unique for each symbol.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let axis = |i: usize| AXES.get(i).copied().unwrap_or("unknown");
        match *self {
            Self::Coordinate(mu) => write!(f, "q{mu}"),
            Self::Rate(mu) => write!(f, "q_dot{mu}"),
            Self::AngularVelocity(i) => write!(f, "omega_{}", axis(i)),
            Self::Velocity(i) => write!(f, "velocity_{}", axis(i)),
            Self::Force(k) if k < 3 => write!(f, "force_{}", axis(k)),
            Self::Force(k) if k < 6 => write!(f, "moment_{}", axis(k - 3)),
            Self::Force(k) => write!(f, "modal_force{}", k - 6),
            Self::Acceleration(k) if k < 3 => write!(f, "acceleration_{}", axis(k)),
            Self::Acceleration(k) if k < 6 => write!(f, "angular_acceleration_{}", axis(k - 3)),
            Self::Acceleration(k) => write!(f, "modal_acceleration{}", k - 6),
            Self::Gravity(i) => write!(f, "gravity_{}", axis(i)),
            Self::Mass => write!(f, "mass"),
            Self::FirstMoment(i) => write!(f, "first_moment_{}", axis(i)),
            Self::ModalFirstMoment(mu, i) => write!(f, "modal_first_moment{mu}_{}", axis(i)),
            Self::SecondMoment(i, j) => write!(f, "second_moment_{}{}", axis(i), axis(j)),
            Self::PositionModeMoment(mu, i, j) => {
                write!(f, "position_mode_moment{mu}_{}{}", axis(i), axis(j))
            }
            Self::ModeModeMoment(mu, nu, i, j) => {
                write!(f, "mode_mode_moment{mu}_{nu}_{}{}", axis(i), axis(j))
            }
            Self::ModalMass(mu, nu) => write!(f, "modal_mass{mu}_{nu}"),
            Self::Stiffness(mu, nu) => write!(f, "stiffness{mu}_{nu}"),
            Self::Damping(mu, nu) => write!(f, "damping{mu}_{nu}"),
            Self::Intermediate(group, k) => write!(f, "{group}{k}"),
        }
    }
}
