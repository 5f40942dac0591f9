#!/bin/bash
# Counts the instructions of one call of each kernel, and of one constrained acceleration of each mechanism, under
# callgrind and compares them with instruction_counts.json.
# usage: instruction_counts.sh [--update]. Fails if a count grew by more than 3 %. Skips, loudly, without valgrind.
# Built for x86-64-v3 (AVX2), the widest that valgrind can run; times are for another day, counts hardly change with load.
set -u
here=$(cd "$(dirname "$0")" && pwd)
if ! command -v valgrind > /dev/null || [ "$(uname -m)" != x86_64 ]; then
    echo "SKIPPED: instruction counts need valgrind on x86-64" >&2
    exit 0
fi
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$here/../target}
# Named, so that the flags are not meant for what runs while building: the release build of the workspace has that already.
platform=$(rustc -vV | sed -n 's/^host: //p')
programs=$CARGO_TARGET_DIR/$platform/release
for package in kernels mechanisms; do
    RUSTFLAGS="-C target-cpu=x86-64-v3" cargo build --release --quiet --target "$platform" \
        --manifest-path "$here/$package/Cargo.toml" --bin count_$package || exit 1
done
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
counts() { # package, name: instructions of a hundred calls less those of none, by the hundred
    local with without
    for calls in 0 100; do
        valgrind --tool=callgrind --callgrind-out-file="$scratch/out" "$programs/count_$1" "$2" $calls \
            > /dev/null 2> "$scratch/log" || { cat "$scratch/log" >&2; return 1; }
        [ $calls = 0 ] && without=$(awk '/^(totals|summary):/ {print $2; exit}' "$scratch/out")
        [ $calls = 100 ] && with=$(awk '/^(totals|summary):/ {print $2; exit}' "$scratch/out")
    done
    echo $(((with - without) / 100))
}
{
    echo "{"
    separator=""
    for package in kernels mechanisms; do
        for name in $("$programs/count_$package" --list); do
            printf '%s  "%s": %s' "$separator" "$name" "$(counts $package "$name")"
            separator=$',\n'
        done
    done
    printf '\n}\n'
} > "$scratch/counts.json"
if [ "${1:-}" = --update ]; then
    cp "$scratch/counts.json" "$here/instruction_counts.json"
    cat "$here/instruction_counts.json"
    exit 0
fi
python3 - "$here/instruction_counts.json" "$scratch/counts.json" <<'PYTHON'
import json
import sys

before, now = (json.load(open(path)) for path in sys.argv[1:])
grown = 0
for name in sorted(set(before) | set(now)):
    old, new = before.get(name), now.get(name)
    verdict = "new" if old is None else "gone" if new is None else f"{new / old - 1:+.1%}"
    if old is None or new is None or new > 1.03 * old:
        grown, verdict = 1, verdict + "  <-- run with --update if this is meant"
    print(f"{name:32} {old!s:>8} {new!s:>8} {verdict}")
sys.exit(grown)
PYTHON
