//! Fidelity: which terms of the kinetic energy are kept.
//!
//! Equations are never truncated: terms of the *energy* are, and the equations are derived anew. Whatever
//! is dropped, the kept energy has these properties, hence the equations have these integrals:
//!
//! - it does not depend on time explicitly: energy (kinetic + elastic) is conserved without external forces;
//! - it depends on position and rotation of the frame only through the body-resolved velocities, so it is
//!   invariant under rigid motions of space: with P = ∂E/∂v and L = ∂E/∂ω, the linear momentum A P and the
//!   angular momentum A L + p × A P about the inertial origin are conserved without external forces.
//!
//! Both hold for *that fidelity's own* energy and momenta, to integrator accuracy.
//!
//! One more property is not automatic: the equations must not depend on the velocity v of the frame origin
//! (Galilean invariance). The terms v·(ω × m q_μ b_μ) and m v·B q̇ are the two halves of v · d(m r)/dt.
//! With one of them dropped, (±) m B q̇ × v is left over in the rotational equations and (±) m b_μ·(ω × v) in the modal
//! ones: a train at constant speed would make the body swing. They are therefore one [`EnergyTerm`] that is
//! kept or dropped as a whole; every subset of terms then gives equations free of v (a test proves it).
//!
//! Dropping terms can cost positive definiteness for large q: without `RotationQuadratic`, Θ_rr(q) is
//! only the tangent of a positive function. Small displacements are the assumption of every truncated level.

use std::collections::BTreeSet;

use ffrf_model::SecondOrderTerms;

/// One term of the kinetic energy, as the user may keep or drop it.
///
/// Units of every term: J. Frame: body-resolved v and ω. Source: `docs/theory/README.md`, E.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EnergyTerm {
    /// ½ m v·v. Always kept.
    Translation,
    /// v·(ω × m a): eccentricity of the undeformed centre of mass.
    FirstMoment,
    /// v·(ω × m q_μ b_μ) + m v·B q̇: momentum of the deformation, both halves of v · d(m r)/dt.
    ModalMomentum,
    /// ½ ω·Θ ω: inertia of the undeformed body. Always kept.
    Rotation,
    /// ω·(q_μ Θ_μ) ω: change of inertia, first order in q.
    RotationLinear,
    /// ½ q_μ q_ν ω·Θ_μν ω: change of inertia, second order in q.
    RotationQuadratic,
    /// ω·ϑ_μ q̇_μ: spin of the undeformed body against its vibration, Ξ = `[ϑ_μ]`.
    ModalRotation,
    /// q_ν ω·ϑ_νμ q̇_μ: spin against vibration of the deformed body (whirl, the Coriolis term 2 L_ff q̇).
    ModalRotationDeformed,
    /// ½ q̇·Θ_ff q̇. Always kept.
    Modal,
    /// -½ q_μ q_ν ω·Θ(Γ_μν) ω: stress stiffness of centrifugal forces. Zero for a model without geometric stiffness.
    CentrifugalStiffening,
    /// -ω·ϑ(Γ_μν) q_ν q̇_μ: stress stiffness of angular acceleration.
    AngularAccelerationStiffening,
    /// -v·(ω × ½ q_μ q_ν Γ_μν) - v·Γ_μν q_ν q̇_μ: stress stiffness of linear acceleration and gravity, both halves.
    LinearAccelerationStiffening,
}

impl EnergyTerm {
    /// Every term, in the order in which the energy is written.
    pub const ALL: [Self; 12] = [
        Self::Translation,
        Self::FirstMoment,
        Self::ModalMomentum,
        Self::Rotation,
        Self::RotationLinear,
        Self::RotationQuadratic,
        Self::ModalRotation,
        Self::ModalRotationDeformed,
        Self::Modal,
        Self::CentrifugalStiffening,
        Self::AngularAccelerationStiffening,
        Self::LinearAccelerationStiffening,
    ];

    /// The name by which the macro and the command line know the term.
    pub fn name(self) -> &'static str {
        match self {
            Self::Translation => "translation",
            Self::FirstMoment => "first_moment",
            Self::ModalMomentum => "modal_momentum",
            Self::Rotation => "rotation",
            Self::RotationLinear => "rotation_linear",
            Self::RotationQuadratic => "rotation_quadratic",
            Self::ModalRotation => "modal_rotation",
            Self::ModalRotationDeformed => "modal_rotation_deformed",
            Self::Modal => "modal",
            Self::CentrifugalStiffening => "centrifugal_stiffening",
            Self::AngularAccelerationStiffening => "angular_acceleration_stiffening",
            Self::LinearAccelerationStiffening => "linear_acceleration_stiffening",
        }
    }

    /// The term of that name.
    ///
    /// Errors: the name is unknown; the error lists the known ones.
    pub fn from_name(name: &str) -> Result<Self, FidelityError> {
        Self::ALL
            .into_iter()
            .find(|term| term.name() == name)
            .ok_or_else(|| FidelityError::UnknownTerm { found: name.to_owned() })
    }

    /// Whether the term is there only in models with geometric stiffness.
    pub fn is_stiffening(self) -> bool {
        matches!(
            self,
            Self::CentrifugalStiffening
                | Self::AngularAccelerationStiffening
                | Self::LinearAccelerationStiffening
        )
    }

    /// Whether the mass matrix is singular without this term.
    pub fn is_always_kept(self) -> bool {
        matches!(self, Self::Translation | Self::Rotation | Self::Modal)
    }
}

/// Which terms of the kinetic energy are kept.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Fidelity {
    /// The body moves as a rigid one; its modes vibrate in the body frame, uncoupled from that motion.
    Rigid,
    /// Inertia of the undeformed body: Θ_rr = Θ and Θ_rf = Ξ are constant.
    ///
    /// `ModalMomentum` is kept whole, so r follows q; where B = 0 the mass matrix is constant.
    Constant,
    /// Every term up to first order in q: `RotationQuadratic` and geometric stiffness are dropped.
    Linear,
    /// Every term but those of geometric stiffness: what the model is without it.
    Unstiffened,
    /// Every term, those of geometric stiffness where the model has it.
    #[default]
    Full,
    /// These terms, and those that are always kept.
    Terms(BTreeSet<EnergyTerm>),
}

impl Fidelity {
    /// The named levels, in ascending order.
    pub const LEVELS: [Self; 5] = [Self::Rigid, Self::Constant, Self::Linear, Self::Unstiffened, Self::Full];

    /// Whether `term` of the kinetic energy is kept.
    pub fn keeps(&self, term: EnergyTerm) -> bool {
        use EnergyTerm as E;
        term.is_always_kept()
            || match self {
                Self::Rigid => term == E::FirstMoment,
                Self::Constant => matches!(term, E::FirstMoment | E::ModalMomentum | E::ModalRotation),
                Self::Linear => term != E::RotationQuadratic && !term.is_stiffening(),
                Self::Unstiffened => !term.is_stiffening(),
                Self::Full => true,
                Self::Terms(terms) => terms.contains(&term),
            }
    }

    /// Whether a body that holds these terms of second order can be had at this fidelity.
    ///
    /// Errors: [`FidelityError::NotHeld`].
    pub fn check_held(&self, held: SecondOrderTerms) -> Result<(), FidelityError> {
        let inertia = self.keeps(EnergyTerm::RotationQuadratic);
        let stiffness = self.keeps(EnergyTerm::CentrifugalStiffening);
        let (holds, expected) = match held {
            SecondOrderTerms::Known => return Ok(()),
            SecondOrderTerms::Together if inertia == stiffness => return Ok(()),
            SecondOrderTerms::Together => (
                "only the sum of `rotation_quadratic` and `centrifugal_stiffening`",
                "full, linear, constant, rigid, or a list with both of them or neither",
            ),
            _ if !inertia && !stiffness => return Ok(()),
            _ => (
                "neither `rotation_quadratic` nor `centrifugal_stiffening`",
                "linear, constant, rigid, or a list without them",
            ),
        };
        Err(FidelityError::NotHeld { found: self.to_string(), holds, expected })
    }

    /// Whether the stress stiffness of loads at markers is kept: with every term, or with one of geometric stiffness.
    pub fn keeps_load_stiffness(&self) -> bool {
        EnergyTerm::ALL.into_iter().any(|term| term.is_stiffening() && self.keeps(term))
    }

    /// The level with most terms of a body that holds these terms of second order.
    pub fn richest(held: SecondOrderTerms) -> Self {
        let had = |level: &Self| level.check_held(held).is_ok();
        Self::LEVELS.into_iter().rev().find(had).unwrap_or(Self::Rigid)
    }

    /// The kept terms, in the order in which the energy is written.
    pub fn terms(&self) -> impl Iterator<Item = EnergyTerm> + '_ {
        EnergyTerm::ALL.into_iter().filter(|term| self.keeps(*term))
    }

    /// The name by which the macro and the command line know the level; `terms` for a list.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rigid => "rigid",
            Self::Constant => "constant",
            Self::Linear => "linear",
            Self::Unstiffened => "unstiffened",
            Self::Full => "full",
            Self::Terms(_) => "terms",
        }
    }

    /// The named level.
    ///
    /// Errors: the name is unknown; the error lists the known ones.
    pub fn from_name(name: &str) -> Result<Self, FidelityError> {
        Self::LEVELS
            .into_iter()
            .find(|level| level.name() == name)
            .ok_or_else(|| FidelityError::UnknownLevel { found: name.to_owned() })
    }

    /// The fidelity that keeps the terms of these names, and those that are always kept.
    ///
    /// Errors: a name is unknown; the error lists the known ones.
    pub fn from_term_names<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<Self, FidelityError> {
        names.into_iter().map(EnergyTerm::from_name).collect::<Result<_, _>>().map(Self::Terms)
    }
}

impl std::fmt::Display for Fidelity {
    /// `full`, or the list of optional terms as it is written: `[first_moment, modal_rotation]`.
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Terms(terms) => {
                let names: Vec<_> = terms.iter().map(|term| term.name()).collect();
                write!(formatter, "[{}]", names.join(", "))
            }
            level => formatter.write_str(level.name()),
        }
    }
}

impl std::str::FromStr for Fidelity {
    type Err = FidelityError;

    /// The inverse of [`Display`](std::fmt::Display): a level, or terms separated by commas, with or without brackets.
    ///
    /// Errors: a name is unknown; the error lists the known ones.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let bracketed = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
        let list = bracketed.unwrap_or(text);
        if bracketed.is_none() && !list.contains(',') && EnergyTerm::from_name(list).is_err() {
            return Self::from_name(list);
        }
        Self::from_term_names(list.split(',').map(str::trim).filter(|name| !name.is_empty()))
    }
}

/// A fidelity that does not exist.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FidelityError {
    /// Neither a level nor a list.
    #[error(
        "unknown fidelity `{found}`: expected rigid, constant, linear, unstiffened, full, or a list of terms ({})",
        EnergyTerm::ALL.map(EnergyTerm::name).join(", ")
    )]
    UnknownLevel {
        /// What was written.
        found: String,
    },
    /// Not a term of the kinetic energy.
    #[error(
        "unknown energy term `{found}`: expected {}; the halves of `modal_momentum` cannot be parted \
         (the equations would depend on the absolute velocity)",
        EnergyTerm::ALL.map(EnergyTerm::name).join(", ")
    )]
    UnknownTerm {
        /// What was written.
        found: String,
    },
    /// The body lacks a term of the fidelity.
    #[error(
        "fidelity {found} cannot be had: the body holds {holds} (it was read from integrals); expected {expected}"
    )]
    NotHeld {
        /// The fidelity.
        found: String,
        /// What the body holds.
        holds: &'static str,
        /// The fidelities that it has.
        expected: &'static str,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_nested() {
        for pair in Fidelity::LEVELS.windows(2) {
            assert!(pair[0].terms().all(|term| pair[1].keeps(term)), "{pair:?}");
            assert!(pair[0].terms().count() < pair[1].terms().count(), "{pair:?}");
        }
    }

    #[test]
    fn names_round_trip() {
        for term in EnergyTerm::ALL {
            assert_eq!(EnergyTerm::from_name(term.name()), Ok(term));
        }
        for level in Fidelity::LEVELS {
            assert_eq!(Fidelity::from_name(level.name()), Ok(level));
        }
    }

    #[test]
    fn a_list_keeps_what_it_names_and_what_every_level_needs() {
        let list = Fidelity::from_term_names(["modal_rotation"]).unwrap();
        let kept: Vec<_> = list.terms().map(EnergyTerm::name).collect();
        assert_eq!(kept, ["translation", "rotation", "modal_rotation", "modal"]);
        assert_eq!(list.to_string(), "[modal_rotation]");
        assert_eq!(Fidelity::Full.to_string(), "full");
    }

    #[test]
    fn what_is_printed_is_read_back() {
        let lists = [vec![], vec!["modal_rotation"], vec!["first_moment", "modal_rotation"]];
        let lists = lists.into_iter().map(|list| Fidelity::from_term_names(list).unwrap());
        for fidelity in Fidelity::LEVELS.into_iter().chain(lists) {
            assert_eq!(fidelity.to_string().parse(), Ok(fidelity));
        }
        assert_eq!(
            "modal_rotation,first_moment".parse(),
            Fidelity::from_term_names(["first_moment", "modal_rotation"])
        );
        assert_eq!("modal_rotation".parse(), Fidelity::from_term_names(["modal_rotation"]));
        assert!(matches!("quadratic".parse::<Fidelity>(), Err(FidelityError::UnknownLevel { .. })));
        assert!(matches!("full,modal".parse::<Fidelity>(), Err(FidelityError::UnknownTerm { .. })));
    }

    #[test]
    fn what_a_body_holds_limits_the_fidelity() {
        use SecondOrderTerms::{Known, Together, Unknown};
        let allowed = |held: SecondOrderTerms| {
            let levels = Fidelity::LEVELS.into_iter().filter(|level| level.check_held(held).is_ok());
            levels.map(|level| level.to_string()).collect::<Vec<_>>()
        };
        assert_eq!(allowed(Known).len(), Fidelity::LEVELS.len());
        assert_eq!(allowed(Together), ["rigid", "constant", "linear", "full"]);
        assert_eq!(allowed(Unknown), ["rigid", "constant", "linear"]);
        let one = Fidelity::from_term_names(["centrifugal_stiffening"]).unwrap();
        let message = one.check_held(Together).unwrap_err().to_string();
        assert!(message.contains("[centrifugal_stiffening] cannot be had"), "{message}");
        assert!(one.check_held(Unknown).is_err());
    }

    #[test]
    fn an_unknown_term_is_answered_with_the_known_ones() {
        let message = Fidelity::from_term_names(["first_moment_deformed"]).unwrap_err().to_string();
        assert!(message.contains("first_moment_deformed") && message.contains("modal_momentum"), "{message}");
    }
}
