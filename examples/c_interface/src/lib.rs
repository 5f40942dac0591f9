//! Compiled Rust behind a C header, as a static library: `include/slider_crank.h` and `include/free_rod.h`.
//!
//! `parts` is what you would write for your own machine; `border` is how C reaches it. No heap, no panic, bounded work per
//! step: the memory is the caller's. See docs/c.md.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

#[allow(unsafe_code)] // the border to C
pub mod border;
pub mod parts;

/// There is none that is reached; a static library without the standard library must say what would follow.
#[cfg(not(feature = "std"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
