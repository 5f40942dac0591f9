#!/bin/sh
# Modes of a brick of 92,000 degrees of freedom: this project against SciPy's eigsh (shift-invert, SuperLU).
# Both read the same matrices and run one after the other, on the same processors.
# Usage: [MODES="20 50 100 200"] [SUPPORTS="free clamped"] [PYTHON=with_scipy] [OURS=built_example] brick.sh
# Prints one row of a table for each number of modes; without PYTHON, SciPy is installed into a temporary folder.
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python=${PYTHON:-}
if [ -z "$python" ]; then
    python3 -m venv "$work/venv"
    "$work/venv/bin/pip" install --quiet numpy scipy
    python="$work/venv/bin/python"
fi
ours=${OURS:-}
if [ -z "$ours" ]; then
    cargo build --release --quiet -p ffrf-fe --example brick_modes
    ours="${CARGO_TARGET_DIR:-target}/release/examples/brick_modes"
fi
"$ours" --write "$work/brick" --no-solve
number() { awk -v key="$1" '$1 == key { print $2; exit }' "$2"; }
echo
echo "| support | modes | ffrf s | SciPy s | ratio | ffrf MB | SciPy MB | ratio | frequencies differ by | our residuals | load |"
echo "|---|---|---|---|---|---|---|---|---|---|---|"
for support in ${SUPPORTS:-free clamped}; do
    for modes in ${MODES:-20 50 100 200}; do
        clamped=""
        [ "$support" = free ] || clamped="--clamped"
        load=$(cut -d' ' -f1 /proc/loadavg 2>/dev/null || echo unknown)
        "$ours" --modes "$modes" --threads 2 $clamped >"$work/ours"
        OMP_NUM_THREADS=2 OPENBLAS_NUM_THREADS=2 "$python" benches/peers/brick_scipy.py "$work/brick" "$modes" "$support" >"$work/peer"
        grep '^frequency_hz' "$work/ours" >"$work/a"
        grep '^frequency_hz' "$work/peer" >"$work/b"
        differ=$(paste "$work/a" "$work/b" | awk '{ d = $2 / $4 - 1; if (d < 0) d = -d; if (d > worst) worst = d }
            END { printf "%.1e", worst }')
        awk -v support="$support" -v modes="$modes" -v differ="$differ" -v load="$load" \
            -v residual="$(number largest_residual "$work/ours")" \
            -v s="$(number solve_seconds "$work/ours")" -v peer_s="$(number solve_seconds "$work/peer")" \
            -v mb="$(number peak_megabytes "$work/ours")" -v peer_mb="$(number peak_megabytes "$work/peer")" \
            'BEGIN { printf "| %s | %d | %.1f | %.1f | %.2f | %.0f | %.0f | %.2f | %s | %s | %s |\n",
                support, modes, s, peer_s, s / peer_s, mb, peer_mb, mb / peer_mb, differ, residual, load }'
    done
done
