#!/bin/sh
# Modes of a brick of 92,000 degrees of freedom: this project against SciPy's eigsh (shift-invert, SuperLU).
# Both read the same matrices and run one after the other, on the same processors. Usage: brick.sh [RUNS]
set -eu
cd "$(dirname "$0")/../.."
runs=${1:-1}
modes=20
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet numpy scipy
cargo build --release --quiet -p ffrf-fe --example brick_modes
ours="${CARGO_TARGET_DIR:-target}/release/examples/brick_modes"
"$ours" --write "$work/brick" --no-solve
number() { awk -v key="$1" '$1 == key { print $2; exit }' "$2"; }
run=1
while [ "$run" -le "$runs" ]; do
    echo "== run $run of $runs, load $(cut -d' ' -f1-3 /proc/loadavg 2>/dev/null || echo unknown)"
    echo "-- ffrf"
    "$ours" --modes "$modes" --threads 2 >"$work/ours"
    grep -v '^frequency_hz' "$work/ours"
    echo "-- SciPy"
    OMP_NUM_THREADS=2 OPENBLAS_NUM_THREADS=2 "$work/venv/bin/python" benches/peers/brick_scipy.py "$work/brick" "$modes" >"$work/peer"
    grep -v '^frequency_hz' "$work/peer"
    for key in solve_seconds peak_megabytes; do
        awk -v key="$key" -v ours="$(number $key "$work/ours")" -v peer="$(number $key "$work/peer")" \
            'BEGIN { printf "ratio %s: %.3f (ffrf %s, SciPy %s)\n", key, ours / peer, ours, peer }'
    done
    grep '^frequency_hz' "$work/ours" >"$work/a"
    grep '^frequency_hz' "$work/peer" >"$work/b"
    paste "$work/a" "$work/b" | awk '{ d = $2 / $4 - 1; if (d < 0) d = -d; if (d > worst) worst = d }
        END { printf "largest relative difference of %d frequencies: %.1e\n", NR, worst }'
    run=$((run + 1))
done
