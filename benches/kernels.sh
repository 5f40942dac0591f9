#!/bin/bash
# Times our generated bodies against each other, in one run: layouts, scalar types, strategies, storage of the moments.
# usage: kernels.sh [ROUNDS]; writes kernels.md. CPU: core to stay on (default 1). Against other tools: peers/run.sh.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
rounds=${1:-300}
target=${CARGO_TARGET_DIR:-$here/kernels/target}/timing
scratch=$(mktemp)
trap 'rm -f "$scratch"' EXIT
run() { # target-cpu
    RUSTFLAGS="-C target-cpu=$1" CARGO_TARGET_DIR=$target/$1 cargo build --release --quiet --manifest-path "$here/kernels/Cargo.toml" --bin kernels
    taskset -c "${CPU:-1}" "$target/$1/release/kernels" "$rounds"
}
{
    echo "# Kernels, $(date +%F)"
    echo
    echo "$(uname -m), $(awk -F': ' '/model name/ {print $2; exit}' /proc/cpuinfo); $(rustc -V)."
    echo "Command: \`benches/kernels.sh $rounds\`. Nanoseconds per call: median (minimum) of $rounds rounds, the columns of one"
    echo "number of modes taking turns. Random unsymmetric bodies, Θ_ff = I; ratios are of medians."
    echo
    echo "# target-cpu=native"
    echo
    run native
    echo "# target-cpu=x86-64, the default"
    echo
    run x86-64
} > "$scratch"
cp "$scratch" "$here/kernels.md"
cat "$here/kernels.md"
