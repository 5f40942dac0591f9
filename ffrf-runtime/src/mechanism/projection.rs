//! Positions and velocities projected on the constraints.

use nalgebra::RealField;

use super::constrained::{constraints, equations};
use super::projected::{Projected, enough};
use super::{Assembly, Constrained, Constraints, Equations, EvaluatedJoint, ImplicitTerms, Level, Storage};
use crate::integrators::{Drift, StepError};

/// The joints after one correction of a level by the factors that there are.
fn corrected<'a, 's, A: Assembly<T>, T: RealField + Copy>(
    assembly: &'a A,
    ports: &'a mut A::Ports<'_>,
    storage: &'a mut Storage<'s, T>,
    (equations, supported): (Equations, bool),
    level: Level,
    drive: &dyn Fn(usize) -> [T; 3],
) -> Constraints<'a, 's, T> {
    constraints(assembly, ports, storage, equations, supported).correct(level);
    assembly.correct(ports, level);
    let mut evaluated = constraints(assembly, ports, storage, equations, supported);
    match level {
        Level::Position => evaluated.evaluate(drive),
        Level::Velocity => evaluated.follow_velocities(),
    }
    evaluated
}

impl<A> Constrained<'_, A> {
    /// One correction of places and one of velocities by one factorisation, whatever is left then: what [`project`](Self::project)
    /// does with one iteration. `gamma_h`: of the stages of a linearly implicit step (s), none of explicit ones; soft rows resist
    /// nothing here. `look` is shown the joints before and behind.
    ///
    /// Errors: there are no factors.
    pub fn correct_once<T>(
        &self,
        time: T,
        state: A::State,
        gamma_h: Option<T>,
        mut look: impl FnMut(&[Option<EvaluatedJoint<T>>]),
    ) -> Result<A::State, StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let assembly = self.0;
        let implicit = gamma_h.map(|gamma_h| ImplicitTerms { gamma_h, subtracted: None, chart: None });
        let mut rooms = assembly.rooms();
        let mut ports = assembly.ports(&mut rooms, state, implicit);
        let equations = equations(assembly, false);
        assembly.with_storage(equations, |storage| {
            let drive = |joint| assembly.drive(joint, time);
            let mut evaluated = constraints(assembly, &mut ports, storage, equations, true);
            evaluated.evaluate(&drive);
            look(evaluated.storage.joints);
            evaluated.factor()?;
            for level in [Level::Position, Level::Velocity] {
                corrected(assembly, &mut ports, storage, (equations, true), level, &drive);
            }
            look(storage.joints);
            Ok(())
        })?;
        Ok(assembly.state(ports))
    }

    /// At most so many corrections by code that holds the whole mechanism at once, until there is nothing left that another one
    /// would take away; `None` where there is no such code, or it does not hold.
    pub(super) fn projected_straight<T>(
        &self,
        time: T,
        state: &A::State,
        gamma_h: Option<T>,
        iterations: usize,
    ) -> Option<Projected<A::State, T>>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        if iterations == 0 {
            return None;
        }
        let mut projected = self.0.straight_projection(time, state, gamma_h)?;
        for _ in 1..iterations {
            if projected.is_closed() {
                break;
            }
            let next = self.0.straight_projection(time, &projected.state, gamma_h)?;
            projected = Projected { before: projected.before, ..next };
        }
        Some(projected)
    }

    /// Projects positions, then velocities, on the constraints; the drift is what was found before.
    ///
    /// One factorisation; the corrections are repeated with it, at most as often as the treatment says. After a linearly
    /// implicit step they must be measured by the matrix of its stages (`gamma_h`): measured by the mass matrix alone they
    /// push stiff modes, and the next step pushes back, without end; the same with soft rows. Errors: a residual is left.
    pub fn project<T>(
        &self,
        time: T,
        state: A::State,
        gamma_h: Option<T>,
        iterations: usize,
        tolerance: T,
    ) -> Result<(A::State, Drift<T>), StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let soft = gamma_h.filter(|_| self.0.soft(0).is_some());
        self.project_against(time, state, [gamma_h, soft], (iterations, tolerance), true)
    }

    /// [`project`](Self::project) with γ h of the modes and, if they resist, of soft rows. `supported`: whether bodies may stand on
    /// their supports, which are met then whatever the other joints ask for.
    pub(super) fn project_against<T>(
        &self,
        time: T,
        state: A::State,
        [gamma_h, soft]: [Option<T>; 2],
        (iterations, tolerance): (usize, T),
        supported: bool,
    ) -> Result<(A::State, Drift<T>), StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let assembly = self.0;
        let with_soft = soft.is_some();
        if assembly.connections().is_empty() {
            return Ok((state, Drift::none()));
        }
        let implicit = gamma_h.map(|gamma_h| ImplicitTerms { gamma_h, subtracted: None, chart: None });
        let mut rooms = assembly.rooms();
        let mut ports = assembly.ports(&mut rooms, state, implicit);
        let equations = equations(assembly, with_soft);
        let drift = assembly.with_storage(equations, |storage| {
            let drive = |joint| assembly.drive(joint, time);
            let mut evaluated = constraints(assembly, &mut ports, storage, equations, supported);
            evaluated.evaluate(&drive);
            let mut left = evaluated.residuals();
            let drift = Drift { position: left.0[0], velocity: left.0[1] };
            let round_off = evaluated.round_off();
            let mut factored = false;
            for level in [Level::Position, Level::Velocity] {
                let index = if level == Level::Position { 0 } else { 1 };
                let enough = enough(left.0[index], round_off[index]);
                for _ in 0..iterations {
                    if left.0[index] <= enough {
                        break;
                    }
                    let mut evaluated = constraints(assembly, &mut ports, storage, equations, supported);
                    if !factored {
                        if let Some(gamma_h) = soft {
                            evaluated.soften(assembly, gamma_h);
                        }
                        evaluated.factor()?;
                        factored = true;
                    }
                    let by = (equations, supported);
                    left = corrected(assembly, &mut ports, storage, by, level, &drive).residuals();
                }
            }
            if left.0[0] <= tolerance {
                Ok(drift)
            } else {
                let residual = nalgebra::try_convert(left.0[0]).unwrap_or(f64::NAN);
                Err(StepError::ConstraintsNotMet { joint: left.1, residual })
            }
        })?;
        Ok((assembly.state(ports), drift))
    }
}
