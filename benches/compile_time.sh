#!/bin/bash
# Time to expand and compile one body (release), and size of its code, by number of modes: benches/compile_time.json.
# usage: compile_time.sh [M ...]. The dependencies are compiled before the clock starts; the clock runs over the
# generator (a build script here, the macro does the same work) and over rustc for the crate that holds the body.
# Code: `write_equations_of_motion` and `forward_dynamics` with all they call, without tables.
set -u
here=$(cd "$(dirname "$0")" && pwd)
work=${WORK:-$(mktemp -d)}
python=${PYTHON:-python3}
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$work/cargo}/compile-time RUSTFLAGS="-C target-cpu=native"
[ $# = 0 ] && set -- 1 2 4 8 16 32 64
"$python" -c "import numpy" 2> /dev/null || { echo "SKIPPED: bodies.py needs numpy; set PYTHON" >&2; exit 0; }
"$python" "$here/peers/bodies.py" "$work" 1 "$@" || exit 1
build() { FFRF_BODY=$work/body_$1.bin cargo build --release --quiet --manifest-path "$here/peers/ours/Cargo.toml"; }
build 1 || exit 1
limit() { case $1 in 8) echo "3 12";; 32) echo "10 24";; 64) echo "20 -";; *) echo "- -";; esac; }
separator="["
for m in "$@"; do
    touch "$here/peers/ours/src/lib.rs"
    export FFRF_BODY=$work/body_$m.bin
    start=$(date +%s.%N)
    build "$m" || exit 1
    seconds=$(echo "$(date +%s.%N) $start" | awk '{printf "%.2f", $1 - $2}')
    code=$(nm --print-size --radix=d --defined-only "$CARGO_TARGET_DIR/release/libours.so" |
        awk '$4 ~ /ffrf|ours|lanes/ && tolower($3) == "t" {s += $2} END {printf "%.1f", s / 1024}')
    set -- $(limit "$m") "$@"
    printf '%s\n  {"modes": %d, "seconds": %s, "code_kilobytes": %s, "limits": "%s s, %s kB"}' "$separator" "$m" "$seconds" "$code" "$1" "$2"
    shift 2
    separator=","
done | tee "$here/compile_time.json"
echo ']' | tee -a "$here/compile_time.json"
