//! The pendulum in each formulation: pinned at node 0, observed at the last node.

use std::error::Error;

use ffrf_fe::FeModel;
use ffrf_fe::formulations::corotated::{CorotatedModel, Frame, GroundJoint, Midpoint, Motion};
use ffrf_fe::formulations::floating::{FloatingBody, FloatingMotion, Pin, RungeKutta};

use crate::bodies::free_modes;

/// Times and positions of the tip.
pub type Path = Vec<(f64, [f64; 3])>;

/// How the motion is computed.
pub enum Formulation {
    /// Whole mesh; `None`: frame by the mean deformation.
    Absolute { frame: Option<Frame>, nonlinear_term: bool },
    /// Generalised component modes, orthonormal.
    Generalized { modes: usize },
    /// Floating frame with free-free modes.
    Floating { modes: usize },
}

impl Formulation {
    pub fn absolute() -> Self {
        Self::Absolute { frame: None, nonlinear_term: true }
    }
}

/// A body pinned at its first node; node 0 is at the origin.
pub struct Pendulum {
    model: FeModel,
    gravity: [f64; 3],
    spin: [f64; 3],
}

impl Pendulum {
    /// Gravity of `scale` times 9.81 m/s² and a spin that grows with the root of `scale`: both deform in proportion.
    pub fn new(model: FeModel, scale: f64) -> Self {
        let spin = [0.4, 0.0, 1.5].map(|x| x * scale.sqrt());
        Self { model, gravity: [0.0, 0.0, -9.81 * scale], spin }
    }

    /// Path of the tip over `steps` steps.
    pub fn tip_path(
        &self,
        formulation: &Formulation,
        time: f64,
        steps: usize,
    ) -> Result<Path, Box<dyn Error>> {
        let tip = self.model.nodes.len() - 1;
        match formulation {
            Formulation::Absolute { frame, nonlinear_term } => {
                let mut body = CorotatedModel::absolute(&self.model)?;
                body.nonlinear_term = *nonlinear_term;
                let frame = frame.clone().unwrap_or_else(|| body.mean_frame());
                self.corotated(&body, frame, GroundJoint::node(0), &GroundJoint::node(tip), time, steps)
            }
            Formulation::Generalized { modes } => {
                let shapes = free_modes(&self.model, *modes)?;
                let body = CorotatedModel::generalized(&self.model, shapes.as_ref())?;
                let (body, combined) = body.orthonormal()?;
                let joint = |node: usize| {
                    let x = self.model.nodes.positions[node];
                    combined.joint(&GroundJoint::generalized(x, shapes.as_ref(), node))
                };
                self.corotated(&body, body.mean_frame(), joint(0), &joint(tip), time, steps)
            }
            Formulation::Floating { modes } => self.floating(*modes, time, steps),
        }
    }

    fn corotated(
        &self,
        body: &CorotatedModel,
        frame: Frame,
        held: GroundJoint,
        tip: &GroundJoint,
        time: f64,
        steps: usize,
    ) -> Result<Path, Box<dyn Error>> {
        let mut rule = Midpoint::new(body, frame, &[held], time / steps as f64)?;
        rule.load = body.gravity(self.gravity);
        let spin = ffrf_fe::formulations::rotation::skew(self.spin);
        let velocity = body.from_body_frame(body.reference.as_ref(), spin.as_ref());
        let mut motion = Motion { time: 0.0, position: body.reference.clone(), velocity };
        let mut path = vec![(0.0, tip.point(&motion.position))];
        for _ in 0..steps {
            rule.advance(&mut motion)?;
            path.push((motion.time, tip.point(&motion.position)));
        }
        Ok(path)
    }

    fn floating(&self, modes: usize, time: f64, steps: usize) -> Result<Path, Box<dyn Error>> {
        let shapes = free_modes(&self.model, modes)?;
        let body = FloatingBody::new(&self.model, shapes.as_ref())?;
        let rows = |node: usize| shapes.as_ref().subrows(3 * node, 3).to_owned();
        let positions = &self.model.nodes.positions;
        let pin = Pin { position: positions[0], shapes: rows(0) };
        let rule = RungeKutta { body: &body, gravity: self.gravity, pin: Some(pin) };
        let mut motion = FloatingMotion {
            time: 0.0,
            origin: [0.0; 3],
            theta: [1.0, 0.0, 0.0, 0.0],
            q: vec![0.0; modes],
            velocity: [0.0; 3],
            omega: self.spin,
            q_dot: vec![0.0; modes],
        };
        let tip = positions.len() - 1;
        let observed = rows(tip);
        let point = |motion: &FloatingMotion| motion.point(positions[tip], observed.as_ref());
        let mut path: Path = vec![(0.0, point(&motion))];
        for _ in 0..steps {
            rule.advance(&mut motion, time / steps as f64);
            path.push((motion.time, point(&motion)));
        }
        Ok(path)
    }
}

/// Largest distance over the common times of two paths of the same duration.
pub fn largest_distance(a: &Path, b: &Path) -> f64 {
    let (fine, coarse) = if a.len() > b.len() { (a, b) } else { (b, a) };
    let stride = (fine.len() - 1) / (coarse.len() - 1);
    if stride * (coarse.len() - 1) != fine.len() - 1 {
        return between(fine[fine.len() - 1].1, coarse[coarse.len() - 1].1);
    }
    coarse.iter().zip(fine.iter().step_by(stride)).map(|(p, q)| between(p.1, q.1)).fold(0.0, f64::max)
}

fn between(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}
