//! What holds where numbers are as large, as small or as unsuitable as they get: `docs/extremes.md` is made of this.
//!
//! `FFRF_UPDATE_EXTREMES=1 cargo test --test extremes` writes the page anew.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::sync::LazyLock;

use table::Section;

mod amplitudes;
mod chains;
mod dependent_modes;
mod far_away;
mod long_spin;
mod non_finite;
mod orientations;
mod page;
mod ratios;
mod redundant;
mod settings;
mod spin;
mod stability;
mod stiffness;
mod table;
mod tolerances;
mod two_masses;
mod units;

/// Every extreme: measured once, held against its bounds by a test of its own, and all together by the page.
macro_rules! extremes {
    ($($name:ident),* $(,)?) => {
        mod measured {
            use super::*;
            $(
                #[allow(non_upper_case_globals)]
                pub static $name: LazyLock<Section> = LazyLock::new(super::$name::section);
            )*
        }

        $(
            #[test]
            fn $name() {
                measured::$name.check();
            }
        )*

        #[test]
        fn the_page_is_what_is_measured() {
            page::compare(&[$(&measured::$name),*]);
        }
    };
}

extremes![
    spin,
    amplitudes,
    ratios,
    stiffness,
    dependent_modes,
    far_away,
    long_spin,
    stability,
    orientations,
    chains,
    redundant,
    units,
    non_finite,
];
