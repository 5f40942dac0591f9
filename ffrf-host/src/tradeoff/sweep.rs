//! All configurations over the cores of the machine.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use super::{Configuration, Outcome, Reference, SceneModes, Study, TradeoffError, Variant, run};

/// How far a sweep is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Done {
    /// Outcomes that are there, those of earlier sweeps included.
    pub done: usize,
    /// All configurations.
    pub total: usize,
}

/// Runs the configurations that `known` has no outcome of, hands outcomes to `keep` as soon as they are there, and gives all
/// of them in the order of `configurations`.
///
/// The costliest come first, so that no core waits at the end for one that came late. What has come while `keep` was at work it
/// gets together: however slow it is, nobody waits for it but the end. `threads`: at least one.
/// Errors: what `keep` says, and variants that cannot be composed.
pub fn sweep(
    study: &Study,
    reference: &Reference,
    configurations: &[Configuration],
    known: &BTreeMap<String, Outcome>,
    threads: usize,
    keep: &mut dyn FnMut(&[Outcome], Done) -> std::io::Result<()>,
) -> Result<Vec<Outcome>, TradeoffError> {
    let mut missing: Vec<&Configuration> =
        configurations.iter().filter(|one| !known.contains_key(&one.key())).collect();
    missing.sort_by(|a, b| b.expected_effort().total_cmp(&a.expected_effort()));
    let variants = variants(study, &missing)?;
    let variant_of = |one: &Configuration| variants.get(&variant_key(one));
    let next = AtomicUsize::new(0);
    let mut found: BTreeMap<String, Outcome> = known.clone();
    let (total, mut done) = (configurations.len(), configurations.len() - missing.len());
    thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        for _ in 0..threads.clamp(1, missing.len().max(1)) {
            let (sender, next, missing) = (sender.clone(), &next, &missing);
            scope.spawn(move || {
                while let Some(one) = missing.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let Some(variant) = variant_of(one) else { continue };
                    if sender.send(run(study, variant, reference, one)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        while let Ok(first) = receiver.recv() {
            let come: Vec<Outcome> = std::iter::once(first).chain(receiver.try_iter()).collect();
            done += come.len();
            // the receiver goes with an error, and with it the threads after their runs
            keep(&come, Done { done, total })?;
            found.extend(come.into_iter().map(|outcome| (outcome.configuration.key(), outcome)));
        }
        Ok::<(), TradeoffError>(())
    })?;
    Ok(configurations.iter().filter_map(|one| found.get(&one.key()).cloned()).collect())
}

fn variant_key(one: &Configuration) -> (SceneModes, String) {
    (one.modes.clone(), one.fidelity.to_string())
}

/// Every variant that is needed, composed once.
fn variants(
    study: &Study,
    needed: &[&Configuration],
) -> Result<BTreeMap<(SceneModes, String), Variant>, TradeoffError> {
    let mut variants = BTreeMap::new();
    for one in needed {
        if let std::collections::btree_map::Entry::Vacant(place) = variants.entry(variant_key(one)) {
            place.insert(study.variant(&one.modes, &one.fidelity)?);
        }
    }
    Ok(variants)
}
