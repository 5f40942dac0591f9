#!/bin/bash
# Builds the columns for one number of modes. usage: columns.sh M; environment: WORK, PYTHON, CARGO_TARGET_DIR.
# Prints name=library for each column that could be built; says why on standard error if one could not.
set -u
here=$(cd "$(dirname "$0")" && pwd)
modes=$1
body=$WORK/body_$modes.bin
flags="-O3 -march=native -fPIC -shared"

built() { # name command...: builds $WORK/name_M.so within ten minutes
    local name=$1 library=$WORK/$1_$modes.so
    shift
    if timeout 600 "$@" -o "$library" > "$WORK/$name.log" 2>&1; then
        echo "$name=$library"
    else
        echo "SKIPPED: $name at $modes modes: $(tail -n 1 "$WORK/$name.log")" >&2
    fi
}

ours() { # name target-cpu features
    local library=$WORK/$1_$modes.so target=$CARGO_TARGET_DIR/$2
    if FFRF_BODY=$body RUSTFLAGS="-C target-cpu=$2" CARGO_TARGET_DIR=$target cargo build --release --quiet \
        --manifest-path "$here/ours/Cargo.toml" --features "$3" > "$WORK/$1.log" 2>&1; then
        cp "$target/release/libours.so" "$library" && echo "$1=$library"
    else
        echo "SKIPPED: $1 at $modes modes: $(grep -m 1 '^error' "$WORK/$1.log")" >&2
    fi
}

ours ours native ""
ours ours-default-cpu x86-64 ""
ours naive native naive
fast="-std=c++17 $flags -DNDEBUG -DMODES=$modes"
simd="-mprefer-vector-width=512 -ffp-contract=fast -fno-math-errno"
built vector-gcc g++ $fast $simd "$here/vector.cpp"
if command -v clang++ > /dev/null; then
    built vector-clang clang++ $fast $simd "$here/vector.cpp"
else
    echo "SKIPPED: vector-clang: no clang++" >&2
fi
eigen=${EIGEN:-$(pkg-config --cflags-only-I eigen3 2> /dev/null | sed 's/-I//')}
if [ -n "$eigen" ] && [ "$modes" -le 32 ]; then
    built eigen g++ $fast -isystem $eigen "$here/eigen.cpp"
else
    echo "SKIPPED: eigen at $modes modes: no headers found, or more than 32 modes" >&2
fi
for kind in casadi sympy; do
    [ $kind = casadi ] && limit=32 || limit=4
    if [ "$modes" -gt $limit ]; then
        echo "SKIPPED: $kind at $modes modes: takes too long beyond $limit" >&2
    elif timeout 600 "$PYTHON" "$here/${kind}_c.py" "$body" "$WORK/${kind}_$modes.c" > "$WORK/$kind.log" 2>&1; then
        built $kind gcc $flags "$WORK/${kind}_$modes.c" -lm
    else
        echo "SKIPPED: $kind at $modes modes: $(tail -n 1 "$WORK/$kind.log")" >&2
    fi
done
