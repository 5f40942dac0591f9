//! The simulation: initial state, fixed steps of RK4, and what is recorded on the way.

use std::error::Error;
use std::time::{Duration, Instant};

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{FlexibleBody, FreeBody, State};

use crate::{Conrod, M};

/// Step of RK4, in s: an eighth of the radian of the highest mode (7.8 kHz), so that all eight ring on undamped.
const STEP: f64 = 2.5e-6;
/// Steps from one sample to the next, at the start and later: 20 µs for the ringing, 0.5 ms for the tumbling.
const FINE: usize = 8;
const COARSE: usize = 200;
/// How long samples are taken finely, in s.
pub const FINE_UNTIL: f64 = 0.010;
/// How long pictures are taken, in s; one for each coarse sample.
pub const FRAMES_UNTIL: f64 = 0.150;

/// Spin before the blow: 2865 rpm about y, the axis of middle inertia. Units: rad/s. Frame: body.
const SPIN: [f64; 3] = [0.0, 300.0, 0.0];
/// Blow to the small end, across both bending planes. Units: N s. Frame: body.
const BLOW: [f64; 3] = [0.0, 0.02, 0.02];

/// One moment of the flight.
#[derive(Clone, Copy)]
pub struct Sample {
    pub time: f64,
    pub state: State<SVector<f64, M>>,
    pub kinetic_energy: f64,
    pub elastic_energy: f64,
    pub linear_momentum: Vector3<f64>,
    pub angular_momentum: Vector3<f64>,
}

impl Sample {
    fn of(body: &FreeBody<Conrod>) -> Self {
        Self {
            time: body.time,
            state: body.state,
            kinetic_energy: body.kinetic_energy(),
            elastic_energy: body.elastic_energy(),
            linear_momentum: body.linear_momentum(),
            angular_momentum: body.angular_momentum(),
        }
    }

    /// Kinetic and elastic energy. Units: J.
    pub fn energy(&self) -> f64 {
        self.kinetic_energy + self.elastic_energy
    }
}

/// All that was recorded.
pub struct Record {
    /// Samples at 20 µs.
    pub fine: Vec<Sample>,
    /// Samples at 0.5 ms.
    pub coarse: Vec<Sample>,
    /// The coarse samples that are shown in ParaView.
    pub frames: Vec<Sample>,
    steps: usize,
    stepping: Duration,
}

/// The rod at rest in its rotating frame (stretched by its spin), then struck.
fn launch() -> Result<FreeBody<Conrod>, Box<dyn Error>> {
    let spin = Vector3::from(SPIN);
    let still = SVector::<f64, M>::zeros();
    let stiffness = Conrod.stiffness().factor().ok_or("modal stiffness is not positive definite")?;
    // K q = -Q_f(q, ω, 0); the spin softens the rod so little that few rounds settle it
    let mut q = still;
    for _ in 0..10 {
        q = stiffness.solve(&-Conrod.prepare(&q, &spin, &still).quadratic_velocity.modal);
    }
    // M(q) Δ[v; ω; q̇] = generalised impulse of the blow
    let impulse = Conrod::SMALL_END.force(&q, &Vector3::from(BLOW));
    let modes = Conrod.modal_mass().factor().ok_or("modal mass is not positive definite")?;
    let mass = Conrod.prepare(&q, &spin, &still).eliminate(modes).factor();
    let change = mass.ok_or("mass matrix is not positive definite")?.solve(&impulse);
    Ok(FreeBody::new(Conrod)
        .with_velocity(change.linear)
        .with_spin(spin + change.angular)
        .with_deformation(q, change.modal))
}

/// Simulates `duration` seconds without forces.
pub fn fly(duration: f64) -> Result<Record, Box<dyn Error>> {
    let mut body = launch()?;
    let first = Sample::of(&body);
    let mut record = Record {
        fine: vec![first],
        coarse: vec![first],
        frames: vec![first],
        steps: 0,
        stepping: Duration::ZERO,
    };
    let total = (duration / STEP).round() as usize;
    let fine_steps = (FINE_UNTIL / STEP).round() as usize;
    let frame_steps = (FRAMES_UNTIL / STEP).round() as usize;
    let second = (1.0 / STEP).round() as usize;
    println!("  {total} steps of {:.1} µs, RK4, no forces", 1e6 * STEP);
    while record.steps < total {
        let chunk = if record.steps < fine_steps { FINE } else { COARSE }.min(total - record.steps);
        let start = Instant::now();
        for _ in 0..chunk {
            body.step_rk4(STEP, &())?;
        }
        record.stepping += start.elapsed();
        record.steps += chunk;
        let sample = Sample::of(&body);
        if record.steps <= fine_steps {
            record.fine.push(sample);
        }
        if record.steps.is_multiple_of(COARSE) {
            record.coarse.push(sample);
            if record.steps <= frame_steps {
                record.frames.push(sample);
            }
        }
        if record.steps.is_multiple_of(second) {
            println!("  {:>4.0} s simulated in {:.1} s", body.time, record.stepping.as_secs_f64());
        }
    }
    Ok(record)
}

impl Record {
    /// Relative change of the energy since the start, at a sample.
    pub fn energy_drift(&self, sample: &Sample) -> f64 {
        (sample.energy() - self.coarse[0].energy()) / self.coarse[0].energy()
    }

    /// Relative change of linear and angular momentum since the start, at a sample.
    pub fn momentum_drift(&self, sample: &Sample) -> [f64; 2] {
        let first = &self.coarse[0];
        let relative = |now: &Vector3<f64>, then: &Vector3<f64>| (now - then).norm() / then.norm();
        [
            relative(&sample.linear_momentum, &first.linear_momentum),
            relative(&sample.angular_momentum, &first.angular_momentum),
        ]
    }

    /// Prints drifts, flips, and the time it took.
    pub fn print_summary(&self) {
        let largest = |measure: &dyn Fn(&Sample) -> f64| self.coarse.iter().map(measure).fold(0.0, f64::max);
        let first = &self.coarse[0];
        // half a turn over: the rod's own y axis changes sides
        let flips = self.coarse.windows(2).filter(|pair| {
            (pair[0].state.angular_velocity.y > 0.0) != (pair[1].state.angular_velocity.y > 0.0)
        });
        println!(
            "  energy {:.6} J ({:.2e} J of it elastic), angular momentum {:.6} N m s, {} flips",
            first.energy(),
            first.elastic_energy,
            first.angular_momentum.norm(),
            flips.count()
        );
        println!(
            "  energy drift            {:.1e} (largest, relative)",
            largest(&|s| self.energy_drift(s).abs())
        );
        println!("  linear momentum drift   {:.1e}", largest(&|s| self.momentum_drift(s)[0]));
        println!("  angular momentum drift  {:.1e}", largest(&|s| self.momentum_drift(s)[1]));
        let seconds = self.stepping.as_secs_f64();
        println!(
            "  {:.0} ns per step, {:.0} ns per forward dynamics",
            1e9 * seconds / self.steps as f64,
            0.25e9 * seconds / self.steps as f64
        );
        println!(
            "  real-time factor {:.2} (simulated time over computing time)",
            self.steps as f64 * STEP / seconds
        );
    }
}
