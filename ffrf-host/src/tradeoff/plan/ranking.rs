//! The modes of all bodies in the order of what they take part in a motion.

use std::collections::BTreeMap;

use super::super::{Modes, SceneModes};
use super::modes::ModeUse;

/// The modes of all flexible bodies, those first that take part most.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranking {
    /// Names of the bodies, and how many modes they have.
    bodies: Vec<(String, usize)>,
    /// For each mode the index of its body, and its own from 0.
    order: Vec<(usize, usize)>,
}

impl Ranking {
    /// By the largest elastic energy that each mode stores; the lower mode and the earlier body first where these are equal.
    pub(super) fn of(bodies: &[(&str, usize)], uses: &[ModeUse]) -> Self {
        let energy = |(body, mode): (usize, usize)| {
            let one = uses.iter().find(|one| one.body == bodies[body].0 && one.mode == mode + 1);
            one.map_or(0.0, |one| one.energy)
        };
        let most = bodies.iter().map(|(_, available)| *available).max().unwrap_or(0);
        let each = |mode: usize| (0..bodies.len()).map(move |body| (body, mode));
        let mut order: Vec<(usize, usize)> =
            (0..most).flat_map(each).filter(|(body, mode)| *mode < bodies[*body].1).collect();
        order.sort_by(|a, b| energy(*b).total_cmp(&energy(*a)));
        let bodies = bodies.iter().map(|(name, available)| ((*name).to_owned(), *available)).collect();
        Self { bodies, order }
    }

    /// Names of the bodies, and how many modes they have.
    pub fn bodies(&self) -> &[(String, usize)] {
        &self.bodies
    }

    /// The modes, each with the name of its body and its index from 0.
    pub fn modes(&self) -> impl Iterator<Item = (&str, usize)> {
        self.order.iter().filter_map(|(body, mode)| Some((self.bodies.get(*body)?.0.as_str(), *mode)))
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.order.len()
    }

    /// The first so many of the order.
    pub(super) fn choice(&self, count: usize) -> SceneModes {
        let mut each: BTreeMap<String, Vec<usize>> =
            self.bodies.iter().map(|(name, _)| (name.clone(), Vec::new())).collect();
        for (body, mode) in self.modes().take(count) {
            each.entry(body.to_owned()).or_default().push(mode);
        }
        self.canonical(each.into_iter().map(|(body, modes)| (body, Modes::listed(modes))).collect())
    }

    /// The same modes, but of one body the first so many in its own order.
    pub(super) fn with(&self, modes: &SceneModes, body: &str, count: usize) -> SceneModes {
        let own = self.modes().filter(|(name, _)| *name == body).map(|(_, mode)| mode).take(count);
        let own = Modes::listed(own.collect());
        let all = self.bodies.iter().map(|(name, available)| {
            let modes = if name == body { own.clone() } else { modes.of(name, *available) };
            (name.clone(), modes)
        });
        self.canonical(all.collect())
    }

    /// How many modes of the bodies a choice has.
    pub(super) fn count(&self, modes: &SceneModes) -> usize {
        self.bodies.iter().map(|(name, available)| modes.of(name, *available).count()).sum()
    }

    /// Whether a choice has them all.
    pub(super) fn has_all(&self, modes: &SceneModes) -> bool {
        self.count(modes) == self.len()
    }

    fn canonical(&self, each: BTreeMap<String, Modes>) -> SceneModes {
        let bodies: Vec<(&str, usize)> =
            self.bodies.iter().map(|(name, available)| (name.as_str(), *available)).collect();
        SceneModes::Each(each).canonical(&bodies)
    }
}
