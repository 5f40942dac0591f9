//! The cases for wasm32: plain numbers in and out, so that no memory is shared.
//!
//! `unsafe` stands here in the attributes alone that give the exported functions their names.

use cases::CASES;

/// How many cases there are.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn case_count() -> u32 {
    CASES.len() as u32
}

/// Byte number `place` of the name of case number `case`; zero behind its end.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn name_byte(case: u32, place: u32) -> u32 {
    let name = CASES.get(case as usize).map_or("", |case| case.name);
    name.as_bytes().get(place as usize).copied().unwrap_or(0).into()
}

/// The hash of case number `case` after `steps` steps; zero if it stopped before.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn case_hash(case: u32, steps: u32) -> u64 {
    let mut last = 0;
    if let Some(case) = CASES.get(case as usize) {
        (case.run)(steps, &mut |done, hash| last = if done == steps { hash } else { 0 });
    }
    last
}
