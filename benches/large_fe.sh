#!/bin/sh
# Component modes of large parts: seconds and memory, and the same by SciPy (SuperLU and eigsh) in the same run.
# Usage: [DOFS="100000"] [ELEMENT=hex8|tet10] [INTERFACES=3] [MODES=20] [BASES="craig-bampton attachment"] [THREADS=2] [PEER=scipy|none]
#        [PYTHON=with_scipy] [OURS=built_example] large_fe.sh
# The part is a block of 4 x 2 x 1, its interfaces are rigid: both ends and a patch on a side. Prints one row for each number of
# degrees of freedom and basis; without PYTHON, SciPy is installed into a temporary folder.
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
peer=${PEER:-scipy} element=${ELEMENT:-hex8} interfaces=${INTERFACES:-3} modes=${MODES:-20} threads=${THREADS:-2}
python=${PYTHON:-}
if [ "$peer" = scipy ] && [ -z "$python" ]; then
    python3 -m venv "$work/venv"
    "$work/venv/bin/pip" install --quiet numpy scipy
    python="$work/venv/bin/python"
fi
ours=${OURS:-}
if [ -z "$ours" ]; then
    cargo build --release --quiet -p ffrf-fe --example large_part
    ours="${CARGO_TARGET_DIR:-target}/release/examples/large_part"
fi
number() { awk -v key="$1" '$1 == key { print $2; exit }' "$2"; }
# frequencies NAME FILE FILE: largest relative difference of the frequencies of a name
differ() {
    grep "^$1 " "$2" >"$work/a"
    grep "^$1 " "$3" >"$work/b"
    paste "$work/a" "$work/b" | awk '{ d = $2 / $4 - 1; if (d < 0) d = -d; if (d > worst) worst = d } END { printf "%.1e", worst }'
}
echo "| dofs | element | basis | modes | ffrf s | SciPy s | ratio | ffrf processor s | SciPy processor s | ratio | ffrf MB | SciPy MB | ratio | normal modes differ by | modes differ by | load |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
for dofs in ${DOFS:-100000}; do
    part="--dofs $dofs --element $element --interfaces $interfaces"
    if [ "$peer" = scipy ]; then "$ours" $part --write "$work/part" --no-solve >/dev/null; fi
    for basis in ${BASES:-craig-bampton attachment}; do
        load=$(cut -d' ' -f1 /proc/loadavg 2>/dev/null || echo unknown)
        "$ours" $part --basis "$basis" --modes "$modes" --threads "$threads" >"$work/ours"
        cat "$work/ours" >&2
        seconds=$(number solve_seconds "$work/ours") memory=$(number peak_megabytes "$work/ours")
        if [ "$peer" = scipy ]; then
            OMP_NUM_THREADS=$threads OPENBLAS_NUM_THREADS=$threads "$python" benches/peers/component_modes_scipy.py \
                "$work/part" "$interfaces" "$modes" "$basis" >"$work/peer"
            awk -v s="$seconds" -v ps="$(number solve_seconds "$work/peer")" -v m="$memory" -v pm="$(number peak_megabytes "$work/peer")" \
                -v a="$(differ normal_hz "$work/ours" "$work/peer")" -v b="$(differ frequency_hz "$work/ours" "$work/peer")" \
                -v head="| $(number dofs "$work/ours") | $element | $basis | $(number modes "$work/ours") |" -v load="$load" \
                -v c="$(number processor_seconds "$work/ours")" -v pc="$(number processor_seconds "$work/peer")" \
                'BEGIN { printf "%s %.1f | %.1f | %.2f | %.1f | %.1f | %.2f | %.0f | %.0f | %.2f | %s | %s | %s |\n", head, s, ps, s / ps, c, pc, c / pc, m, pm, m / pm, a, b, load }'
        else
            printf '| %s | %s | %s | %s | %.1f | - | - | %.1f | - | - | %.0f | - | - | - | - | %s |\n' "$(number dofs "$work/ours")" "$element" "$basis" \
                "$(number modes "$work/ours")" "$seconds" "$(number processor_seconds "$work/ours")" "$memory" "$load"
        fi
    done
done
