#!/bin/bash
# What it is worth to find the instruction set when running: our kernels compiled for this processor, for any x86-64 processor
# with what it has found when running (the default), and with nothing found. Prints the minimum of the rounds as a table.
# usage: instruction_sets.sh [ROUNDS, default 300]. Environment: WORK, MODES (default: 8 16 32 64), CPU, PYTHON (with numpy).
# Three to five minutes of building; then three seconds for 100 rounds.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=${WORK:-$(mktemp -d)} rounds=${1:-300} modes=${MODES:-8 16 32 64} python=${PYTHON:-python3}
"$python" -c "import numpy" 2> /dev/null || { echo "SKIPPED: bodies.py needs numpy; set PYTHON" >&2; exit 0; }
gcc -O2 -Wall -o "$work/time_columns" "$here/time_columns.c" -ldl -lm
"$python" "$here/bodies.py" "$work" $modes > /dev/null
build() { # column, target-cpu, further arguments of cargo
    local column=$1 cpu=$2
    shift 2
    for m in $modes; do
        FFRF_BODY=$work/body_$m.bin RUSTFLAGS="-C target-cpu=$cpu" CARGO_TARGET_DIR=$work/$column cargo build --release --quiet \
            --manifest-path "$here/ours/Cargo.toml" "$@"
        cp "$work/$column/release/libours.so" "$work/${column}_$m.so"
    done
}
build native native
build default x86-64
build compiled x86-64 --no-default-features
for m in $modes; do
    taskset -c "${CPU:-1}" "$work/time_columns" "$work/body_$m.bin" "$rounds" \
        native="$work/native_$m.so" default="$work/default_$m.so" compiled="$work/compiled_$m.so"
done > "$work/columns.jsonl"
echo "$(date +%F), $(awk -F': ' '/model name/ {print $2; exit}' /proc/cpuinfo), $(rustc -V), load $(cut -d' ' -f1 /proc/loadavg); nanoseconds,"
echo "the least of $rounds rounds, and that over the native one."
"$python" - "$work/columns.jsonl" <<'PYTHON'
import json
import sys

NAMES = {
    "native": "`target-cpu=native`",
    "default": "default build",
    "compiled": "default target-cpu, nothing found when running",
}
rows = [json.loads(line) for line in open(sys.argv[1])]
modes = sorted({row["modes"] for row in rows})
for kernel in ["equations", "accelerations"]:
    least = {(row["column"], row["modes"]): row[kernel]["minimum_ns"] for row in rows}
    print(f"\n| {kernel}, modes | {' | '.join(map(str, modes))} |\n| --- |{' --- |' * len(modes)}")
    for column, name in NAMES.items():
        cells = [f"{least[column, m]:.0f} ({least[column, m] / least['native', m]:.2f})" for m in modes]
        print(f"| {name} | {' | '.join(cells)} |")
PYTHON
