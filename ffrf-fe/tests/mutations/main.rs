//! Mutated files through every reader: no panic, no hang, an error that can be printed or a consistent model.
//!
//! The samples are the corpus of the fuzz targets. The seed is fixed, so that a failure comes back; another one can be
//! given as `FFRF_MUTATION_SEED`.
#![allow(clippy::unwrap_used)]
#![allow(clippy::panic)] // helpers of tests are tests

mod mutate;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use ffrf_fuzz::{TARGETS, run};
use ffrf_test_kit::random::Random;

/// Inputs of one run.
const INPUTS: usize = 2000;

/// A sound input takes a millisecond or two; the longest accepted growth, 64 MB of repeated files, some seconds.
const LONGEST: Duration = Duration::from_secs(60);

fn samples(target: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target);
    let mut samples: Vec<(String, Vec<u8>)> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap()))
        .collect();
    samples.sort();
    assert!(!samples.is_empty(), "{target} has no samples");
    samples
}

/// Runs one input; a panic or a long run names the target and keeps the input.
fn check(target: &str, input: &[u8], label: &str) -> bool {
    let start = Instant::now();
    let result = catch_unwind(AssertUnwindSafe(|| {
        let outcome = run(target, input);
        outcome.assert_sound();
        outcome.is_accepted()
    }));
    let kept = || {
        let path = std::env::temp_dir().join(format!("ffrf-mutation-{target}-{}", std::process::id()));
        std::fs::write(&path, input).unwrap();
        path
    };
    assert!(
        start.elapsed() < LONGEST,
        "{target}, {label}: {:?}; input: {}",
        start.elapsed(),
        kept().display()
    );
    result.unwrap_or_else(|_| panic!("{target}, {label}: panicked; input: {}", kept().display()))
}

#[test]
fn samples_are_accepted_or_refused_as_their_names_say() {
    for target in &TARGETS {
        let samples = samples(target.name);
        let accepted: Vec<&str> = samples
            .iter()
            .filter(|(name, bytes)| check(target.name, bytes, name))
            .map(|(name, _)| name.as_str())
            .collect();
        assert!(!accepted.is_empty(), "{}: no sample is accepted", target.name);
        let unsound =
            ["announced", "overflow", "twice", "cut", "includes_itself", "beyond", "header_of", "nested"];
        let wrong = accepted.iter().find(|name| unsound.iter().any(|part| name.contains(part)));
        assert_eq!(wrong, None, "{}: accepted", target.name);
    }
}

#[test]
fn mutated_files_are_refused_or_give_a_consistent_model() {
    let seed = std::env::var("FFRF_MUTATION_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let mut random = Random::new(seed);
    let corpora: Vec<_> = TARGETS.iter().map(|target| (target.name, samples(target.name))).collect();
    let mut accepted = 0;
    for number in 0..INPUTS {
        let (target, samples) = &corpora[number % corpora.len()];
        let (name, sample) = &samples[random.below(samples.len())];
        let other = &samples[random.below(samples.len())].1;
        let input = mutate::mutate(sample, other, &mut random);
        accepted +=
            usize::from(check(target, &input, &format!("input {number} of seed {seed}, from {name}")));
    }
    // Mutations that are all refused, or none, would test nothing.
    assert!((INPUTS / 50..INPUTS * 49 / 50).contains(&accepted), "{accepted} of {INPUTS} accepted");
}
