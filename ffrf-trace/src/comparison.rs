//! Comparisons: decided by the values of this run, and written down.

use std::cmp::Ordering;

use crate::Traced;
use crate::tape::{Condition, Relation, write};

impl Traced {
    /// Asks a question whose answer is written down as the relation that holds.
    fn ask(&self, other: &Self, answer: bool, holds: Relation, holds_not: Relation) -> bool {
        let relation = if answer { holds } else { holds_not };
        write(|tape| tape.grant(Condition { left: self.node, right: other.node, relation }));
        answer
    }

    /// Whether it is finite; that it is so, if it is, is written down.
    pub(crate) fn ask_finite(&self) -> bool {
        let condition = Condition { left: self.node, right: self.node, relation: Relation::Finite };
        write(|tape| tape.grant(condition));
        self.value.is_finite()
    }
}

impl PartialEq for Traced {
    fn eq(&self, other: &Self) -> bool {
        self.ask(other, self.value == other.value, Relation::Equal, Relation::NotEqual)
    }
}

impl PartialOrd for Traced {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let order = self.value.partial_cmp(&other.value);
        let relation = match order {
            Some(Ordering::Less) => Relation::Less,
            Some(Ordering::Equal) => Relation::Equal,
            Some(Ordering::Greater) => Relation::Greater,
            // no condition is one under which nothing can be compared
            None => return None,
        };
        self.ask(other, true, relation, relation);
        order
    }

    fn lt(&self, other: &Self) -> bool {
        self.ask(other, self.value < other.value, Relation::Less, Relation::GreaterOrEqual)
    }

    fn le(&self, other: &Self) -> bool {
        self.ask(other, self.value <= other.value, Relation::LessOrEqual, Relation::Greater)
    }

    fn gt(&self, other: &Self) -> bool {
        self.ask(other, self.value > other.value, Relation::Greater, Relation::LessOrEqual)
    }

    fn ge(&self, other: &Self) -> bool {
        self.ask(other, self.value >= other.value, Relation::GreaterOrEqual, Relation::Less)
    }
}
