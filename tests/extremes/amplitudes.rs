//! Amplitudes from nothing to the largest numbers.

use ffrf::{FlexibleBody, FreeBody, ModalVector};

use crate::row;
use crate::settings::{Rod, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::VIBRATING;

pub fn section() -> Section {
    Section {
        title: "Amplitudes from 0 to the largest numbers",
        text: "The connecting rod (4 modes, mass-normalised: a coordinate of 1e-3 is 1 mm of 1 kg) vibrates freely in its first \
               mode, 2,000 RK4 steps of a twentieth of the limit: drift of energy. An absurd amplitude is no error by itself \
               (`Envelope` watches it); where squares leave the number type the step is refused.",
        rows: vec![
            row!("0", undeformed),
            row!("smallest positive number", tiny),
            row!("1e-18", vibrating, 1e-18),
            row!("1e-3", vibrating, 1e-3),
            row!("1e3", vibrating, 1e3),
            row!("1e15", vibrating, 1e15),
            row!("largest number over 1e3", huge),
        ],
    }
}

fn deformed<T: Real>(amplitude: T) -> FreeBody<Rod, T> {
    let rest = FlexibleBody::<T>::undeformed(&Rod);
    let mut q = rest;
    q.as_mut_slice()[0] = amplitude;
    FreeBody::new(Rod).with_deformation(q, rest)
}

fn step<T: Real>() -> T {
    FlexibleBody::<T>::largest_stable_step(&Rod).unwrap() * T::of(0.05)
}

fn undeformed<T: Real>() -> Figure {
    let mut body = deformed(T::zero());
    let before = body.state;
    for _ in 0..100 {
        body.step_rk4(step(), &()).unwrap();
    }
    assert_eq!(body.state, before);
    Figure::Holds("stays, same bits")
}

fn tiny<T: Real>() -> Figure {
    let mut body = deformed(T::of(if T::SINGLE { 1e-45 } else { 5e-324 }));
    for _ in 0..2_000 {
        body.step_rk4(step(), &()).unwrap();
        let largest = body.state.modal_coordinates.largest().double();
        assert!(largest < if T::SINGLE { 1e-38 } else { 1e-307 }, "{largest:e}");
    }
    Figure::Holds("stays below the smallest normal number")
}

fn vibrating<T: Real>(amplitude: f64) -> Figure {
    let mut body = deformed(T::of(amplitude));
    // in units of the amplitude: squares of small numbers vanish in single precision
    let energy = |body: &FreeBody<Rod, T>| {
        let scale = |x: &T| x.double() / amplitude;
        let velocity = body.state.body_velocity().map(|x| scale(&x));
        let q = body.state.modal_coordinates.map(|x| scale(&x));
        let rates = body.state.modal_rates.map(|x| scale(&x));
        let spin = body.state.angular_velocity.map(|x| scale(&x));
        // small amplitudes: the undeformed body's; large ones: of what the deformation makes it
        let at = body.state.modal_coordinates.map(T::double);
        let momentum = FlexibleBody::<f64>::prepare(&Rod, &at, &spin, &rates).mass_times(
            &FlexibleBody::<f64>::modal_mass(&Rod),
            &ffrf::Motion { linear: velocity, angular: spin, modal: rates },
        );
        let velocities = ffrf::Motion { linear: velocity, angular: spin, modal: rates };
        let stiffness = FlexibleBody::<f64>::stiffness(&Rod).product(&q);
        0.5 * momentum.power(&velocities) + 0.5 * q.dot(&stiffness)
    };
    let (first, mut drift) = (energy(&body), 0.0);
    for _ in 0..2_000 {
        if let Err(error) = body.step_rk4(step(), &()) {
            return refused(error);
        }
        drift = largest([drift, (energy(&body) / first - 1.0).abs()]);
    }
    below::<T>(drift, VIBRATING)
}

fn huge<T: Real>() -> Figure {
    let mut body = deformed(T::max_value().unwrap() * T::of(1e-3));
    for _ in 0..100 {
        let before = body.state;
        if let Err(error) = body.step_rk4(step(), &()) {
            assert_eq!(body.state, before);
            return refused(error);
        }
        assert!(body.state.is_finite());
    }
    Figure::Holds("finite")
}
