//! Which modes of a transformed basis are kept.

use super::ComponentModeError;

/// Which modes to keep; every condition given must hold.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ModeSelection {
    /// Least frequency. Units: Hz.
    pub above_hz: Option<f64>,
    /// Greatest frequency. Units: Hz.
    pub below_hz: Option<f64>,
    /// Least share of the static compliance of some interface motion, from 0 to 1.
    pub importance: Option<f64>,
    /// At most this many, those with the greatest share first.
    pub count: Option<usize>,
}

impl ModeSelection {
    /// Errors: limits that are negative or not finite.
    pub(crate) fn check(&self) -> Result<(), ComponentModeError> {
        let limits = [
            ("least frequency", self.above_hz),
            ("greatest frequency", self.below_hz),
            ("least importance", self.importance),
        ];
        for (what, limit) in limits {
            if let Some(found) = limit.filter(|x| !(x.is_finite() && *x >= 0.0)) {
                let (what, expected) = (what.to_owned(), "a finite number of at least 0".to_owned());
                return Err(ComponentModeError::Number { what, expected, found });
            }
        }
        Ok(())
    }

    /// Numbers of the modes kept, ascending.
    pub(crate) fn choose(&self, frequencies: &[f64], importance: &[f64]) -> Vec<usize> {
        let mut chosen: Vec<usize> = (0..frequencies.len())
            .filter(|&k| {
                self.above_hz.is_none_or(|limit| frequencies[k] >= limit)
                    && self.below_hz.is_none_or(|limit| frequencies[k] <= limit)
                    && self.importance.is_none_or(|limit| importance[k] >= limit)
            })
            .collect();
        if let Some(count) = self.count {
            chosen.sort_by(|&a, &b| importance[b].total_cmp(&importance[a]).then(a.cmp(&b)));
            chosen.truncate(count);
            chosen.sort_unstable();
        }
        chosen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conditions_join() {
        let (frequencies, importance) = ([10.0, 20.0, 30.0, 40.0], [0.5, 0.01, 0.2, 0.3]);
        let choose = |selection: ModeSelection| selection.choose(&frequencies, &importance);
        assert_eq!(choose(ModeSelection::default()), [0, 1, 2, 3]);
        assert_eq!(choose(ModeSelection { below_hz: Some(30.0), ..Default::default() }), [0, 1, 2]);
        assert_eq!(choose(ModeSelection { count: Some(2), ..Default::default() }), [0, 3]);
        let both = ModeSelection { above_hz: Some(15.0), importance: Some(0.1), ..Default::default() };
        assert_eq!(choose(both), [2, 3]);
    }
}
