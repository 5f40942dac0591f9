//! Something that moves in steps, and the hash of its way.

use crate::{Hash, Sink};

/// A system in motion.
pub trait Motion {
    /// Advances by one step; whether that was possible.
    fn step(&mut self) -> bool;
    /// Takes every number of the state in.
    fn hash(&self, hash: &mut Hash);
}

/// Advances `steps` times; tells the hash of all states so far after each power of ten, and after the last step.
///
/// A step that is refused ends it: the sink is then told of zero steps.
pub fn follow(mut motion: impl Motion, steps: u32, sink: Sink<'_>) {
    let (mut hash, mut mark) = (Hash::default(), 10);
    for done in 1..=steps {
        if !motion.step() {
            return sink(0, u64::from(done));
        }
        motion.hash(&mut hash);
        if done == mark || done == steps {
            sink(done, hash.0);
            mark = mark.saturating_mul(10);
        }
    }
}
