#!/bin/bash
# Runs of millions of steps: writes long_runs.md. Built for the default target-cpu, as most users have it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
target=${CARGO_TARGET_DIR:-$here/long_runs/target}
CARGO_TARGET_DIR=$target cargo build --release --quiet --manifest-path "$here/long_runs/Cargo.toml"
program=$target/release/long_runs
{
    echo "# Long runs, $(date +%F)"
    echo
    echo "$(uname -m), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1); $(rustc -V). Command: \`benches/long_runs.sh\`."
    echo
    echo "## Free spin beside the intermediate axis"
    echo
    echo "A rigid body (1, 2, 2.5 kg m²) at 1 rad/s, a thousandth beside its intermediate axis, RK4 with steps of 0.01 s; largest"
    echo "drifts over the size of energy and angular momentum. f64 loses what RK4 loses, in proportion to the steps; f32 rounding."
    echo
    "$program" free_spin
    echo
    echo "## A flexible rotor in f32 against f64, over a million steps"
    echo
    echo "Shaft (six modes, every term) and disc of \`models/scenes/flexible_rotor.toml\`, at 300 rad/s without drive, out of balance by a"
    echo "tenth of a millimetre; RK4 with steps of 2⁻¹⁶ s, 15.3 s in all, f32 against f64 with the same steps. The angle grows in"
    echo "proportion to time: rounding has changed the spin by some 1e-5 of itself. The reason is that alone: one unit in the last"
    echo "place of 300 rad/s is 3e-5 rad/s in f32, more than most steps add, so that slow changes of the spin are lost or doubled. The"
    echo "last column has everything in f64 but the spins, which are rounded to f32 after each step: it is the same error. The whirl"
    echo "itself, its size and place in the turning frame, does not suffer: places are apart by the angle times the whirl."
    echo
    "$program" rotor
} > "$here/long_runs.md.new"
mv "$here/long_runs.md.new" "$here/long_runs.md"
cat "$here/long_runs.md"
