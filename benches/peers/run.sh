#!/bin/bash
# Compares our kernels with other ways to the same numbers, see README.md. Environment:
#   WORK    scratch folder (default: a new temporary one)     MODES   numbers of modes (default: 1 2 4 8 16 32 64)
#   ROUNDS  rounds per column (default: 300)                   CPU     core to stay on (default: 1)
#   PASSES  parts of the rounds, in each of which all numbers of modes have their turn (default: 10), so that load
#           that comes and goes within minutes does not fall on some numbers of modes only
#   EXTRA   more columns, name=library with %M for the number of modes
set -u
here=$(cd "$(dirname "$0")" && pwd)
export WORK=${WORK:-$(mktemp -d)} CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-${WORK:-/tmp}/cargo}
modes=${MODES:-1 2 4 8 16 32 64} rounds=${ROUNDS:-300} passes=${PASSES:-10} cpu=${CPU:-1}

export PYTHON=$WORK/venv/bin/python
if [ ! -x "$PYTHON" ]; then
    python3 -m venv "$WORK/venv" && "$WORK/venv/bin/pip" install --quiet numpy scipy casadi sympy exudyn || exit 1
fi
gcc -O2 -Wall -o "$WORK/time_columns" "$here/time_columns.c" -ldl -lm || exit 1
"$PYTHON" "$here/bodies.py" "$WORK" $modes || exit 1

: > "$WORK/columns.jsonl"
failed=0
for m in $modes; do
    bash "$here/columns.sh" "$m" > "$WORK/columns_$m.txt"
    for extra in ${EXTRA:-}; do echo "${extra//%M/$m}" >> "$WORK/columns_$m.txt"; done
done
for pass in $(seq "$passes"); do
    echo "pass $pass of $passes" >&2
    for m in $modes; do
        taskset -c "$cpu" "$WORK/time_columns" "$WORK/body_$m.bin" $(((rounds + passes - 1) / passes)) \
            $(cat "$WORK/columns_$m.txt") >> "$WORK/columns.jsonl" || failed=1
    done
done
taskset -c "$cpu" "$PYTHON" -W ignore "$here/exudyn_rhs.py" $modes > "$WORK/exudyn.jsonl" || echo "SKIPPED: exudyn" >&2
"$PYTHON" "$here/report.py" "$WORK/columns.jsonl" "$WORK/exudyn.jsonl" "$here" "$rounds" || exit 1
exit $failed
