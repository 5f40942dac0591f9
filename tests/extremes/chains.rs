//! Long chains.

use std::fmt::Write;

use crate::row;
use crate::settings::{Setting, largest, scene};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::{CHAIN, LINEAR_COST};

pub fn section() -> Section {
    Section {
        title: "Long chains",
        text: "Links of 1 kg and 1 m on ball joints, the first of them on the ground, fall from a slope: 50 RK4 steps of 1 ms: \
               drift of the energy over the kinetic energy, and the residual of the joints (m). Elimination goes along the tree, so that \
               work is proportional to the number of links (multiply-adds per link with 300 links over those with 30: below 1.1).",
        rows: vec![
            row!("10 links", rk4, 10),
            row!("30 links", rk4, 30),
            row!("300 links", rk4, 300),
            row!("300 links, linearly implicit, with springs in the joints", springs, 300),
            row!("300 links against 30: multiply-adds per link", cost),
        ],
    }
}

/// Downwards by a third.
fn chain(links: usize, springs: bool) -> String {
    let mut text = "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, 0.0, -9.81]\n".to_owned();
    let (along, down) = (0.8, -0.6);
    for k in 0..links {
        let middle = k as f64 + 0.5;
        write!(
            text,
            "[bodies.link{k}]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\n\
             position = [{}, 0.0, {}]\n",
            along * middle,
            down * middle
        )
        .unwrap();
    }
    for k in 0..links {
        let [half, end] = [[0.5 * along, 0.5 * down], [-0.5 * along, -0.5 * down]];
        let (first, place) = match k {
            0 => ("ground".to_owned(), [0.0; 2]),
            _ => (format!("link{}", k - 1), half),
        };
        write!(
            text,
            "[joints.ball{k}]\nkind = \"spherical\"\nfirst = \"{first}\"\nfirst_position = [{}, 0.0, {}]\n\
             second = \"link{k}\"\nsecond_position = [{}, 0.0, {}]\n",
            place[0], place[1], end[0], end[1]
        )
        .unwrap();
        if springs {
            write!(
                text,
                "[forces.coil{k}]\nkind = \"bushing\"\nfirst = \"{first}\"\nfirst_position = [{}, 0.0, {}]\n\
                 second = \"link{k}\"\nsecond_position = [{}, 0.0, {}]\n\
                 stiffness_matrix = [0.0, 0.0, 0.0, 1e6, 1e6, 1e6]\ndamping_matrix = [0.0, 0.0, 0.0, 1e3, 1e3, 1e3]\n",
                place[0], place[1], end[0], end[1]
            )
            .unwrap();
        }
    }
    text
}

fn rk4<T: Real>(links: usize) -> Figure {
    let mut setting = Setting::<T>::of(&chain(links, false));
    let first = setting.energy();
    let mut residual = 0.0;
    for _ in 0..50 {
        match setting.step(T::of(1e-3), false) {
            Ok(report) => residual = largest([residual, report.drift.position.double()]),
            Err(error) => return refused(error),
        }
    }
    let drift = (setting.energy() - first).abs() / setting.kinetic_energy();
    below::<T>(largest([drift, residual]), CHAIN)
}

fn springs<T: Real>(links: usize) -> Figure {
    let mut setting = Setting::<T>::of(&chain(links, true));
    for _ in 0..20 {
        if let Err(error) = setting.step(T::of(1e-3), true) {
            return refused(error);
        }
    }
    assert!(setting.is_finite());
    Figure::Holds("finite")
}

fn cost<T: Real>() -> Figure {
    if T::SINGLE {
        return Figure::Holds("-");
    }
    let per_link = |links: usize| scene(&chain(links, false)).mechanism.solve_cost().0 / links as f64;
    let ratio = per_link(300) / per_link(30);
    assert!(ratio < LINEAR_COST, "{ratio}");
    Figure::Holds("linear")
}
