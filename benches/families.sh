#!/bin/bash
# What modes, terms and number type cost in compiled code: instructions per step under callgrind (times with --times ROUNDS),
# and what they are worth: errors. usage: families.sh [--times ROUNDS]; writes families.md.
# Built for the default target-cpu, as most users have it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
target=${CARGO_TARGET_DIR:-$here/families/target}
rounds=1
[ "${1:-}" = --times ] && rounds=$2
CARGO_TARGET_DIR=$target cargo build --release --quiet --manifest-path "$here/families/Cargo.toml"
program=$target/release/families
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
instructions() { # name: those of a hundred steps less those of none, by the hundred
    local with without
    for steps in 0 100; do
        valgrind --tool=callgrind --callgrind-out-file="$scratch/out" "$program" count "$1" $steps > /dev/null 2> "$scratch/log"
        [ $steps = 0 ] && without=$(awk '/^(totals|summary):/ {print $2; exit}' "$scratch/out")
        [ $steps = 100 ] && with=$(awk '/^(totals|summary):/ {print $2; exit}' "$scratch/out")
    done
    echo $(((with - without) / 100))
}
{
    echo "# A family, $(date +%F)"
    echo
    echo "$(uname -m); $(rustc -V). Command: \`benches/families.sh${1:+ $*}\`. The connecting rod in tumbling flight, one binary,"
    echo "RK4 with steps of 10 µs over 20 ms; error: how far a point half a metre off is misplaced, over that half metre, against"
    echo "eight modes, every term, f64 and an eighth of the step. Instructions of one step: callgrind."
    [ "$rounds" = 1 ] || echo "Times: the least of $rounds rounds of 200 steps, on a machine that others use as well (load $(cut -d' ' -f1 /proc/loadavg))."
    echo
    "$program" "$rounds" | while IFS= read -r line; do
        case $line in
        "| member"*) echo "$line instructions per step |" ;;
        "| ---"*) echo "$line --- |" ;;
        *) echo "$line $(instructions "$(echo "$line" | cut -d' ' -f2)") |" ;;
        esac
    done
} > "$scratch/table"
if [ "$rounds" = 1 ]; then # a time of one round is none
    awk -F'|' 'BEGIN {OFS="|"} /^\|/ {print $1, $2, $3, $4, $5, $7, $8, $9; next} {print}' "$scratch/table" > "$scratch/plain"
    mv "$scratch/plain" "$scratch/table"
fi
cp "$scratch/table" "$here/families.md"
cat "$here/families.md"
