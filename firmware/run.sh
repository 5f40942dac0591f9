#!/usr/bin/env bash
# Runs the same cases on the desktop (default and native), on emulated Cortex-M4F and Cortex-M7, and in wasm32, and compares
# every bit. Sets up what is missing: see toolchain.sh. The exit code says whether all agree.
# usage: run.sh [STEPS [NAME...]]: steps of each case (default 100), and which cases (default all)
# FFRF_SKIP_FIRMWARE=1 skips it, loudly, where there is neither network nor emulator.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
if [ "${FFRF_SKIP_FIRMWARE:-}" = 1 ]; then
    echo "SKIPPED: FFRF_SKIP_FIRMWARE=1, nothing was run on a microcontroller's core or in wasm32" >&2
    exit 0
fi
# The command of the workspace, where the caller has it built; everything here is built into a folder of its own.
ffrf=$(realpath -m "${CARGO_TARGET_DIR:-$here/../target}")/debug/ffrf
. "$here/toolchain.sh"
cd "$here"
built=$here/target${build_std:+/debian}
export CARGO_TARGET_DIR=$built
steps=${1:-100}
shift || true
results=$built/results
mkdir -p "$results"

build() { # RUSTFLAGS, package, target, options...
    local flags=$1 package=$2 target=$3
    shift 3
    RUSTFLAGS="$flags" $CARGO build --quiet --release --locked --package "$package" --target "$target" "$@"
}

core() { # RUSTFLAGS, name: the program for a core, copied to its name
    build "$1" board thumbv7em-none-eabihf --bin board $build_std
    cp "$built/thumbv7em-none-eabihf/release/board" "$results/$2.elf"
}

emulate() { # machine and core as the emulator knows them, program, options, words of the command line...
    local machine=$1 core=$2 program=$3 options=$4 words=arg=board word
    shift 4
    for word in "$@"; do
        words=$words,arg=$word
    done
    # shellcheck disable=SC2086
    timeout "${FFRF_EMULATOR_TIMEOUT:-7200}" qemu-system-arm -machine "$machine" -cpu "$core" -nographic -monitor none -serial null $options \
        -semihosting-config "enable=on,target=native,$words" -kernel "$program"
}
m4() { emulate mps2-an386 cortex-m4 "$results/m4.elf" "$@"; }
m7() { emulate mps2-an500 cortex-m7 "$results/m7.elf" "$@"; }

host=x86_64-unknown-linux-gnu
for flavour in default native; do
    flags=
    [ $flavour = default ] || flags="-C target-cpu=native"
    # little optimised, in contrast to the targets: no bit depends on that either, and it is built sooner
    CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_OPT_LEVEL=1 build "$flags" desktop $host
    "$built/$host/release/desktop" "$steps" "$@" > "$results/desktop-$flavour.txt"
done
core "-C target-cpu=cortex-m4" m4
core "-C target-cpu=cortex-m7" m7
build "" wasm wasm32-unknown-unknown ${build_std:+-Zbuild-std=core,alloc,std,panic_abort}

# The proof that no panic is reachable is one only if a program that can panic does not link.
if build "-C target-cpu=cortex-m7" board thumbv7em-none-eabihf --bin panics --features panics $build_std 2> "$results/panics.log"; then
    echo "FAILED: a program that can panic was linked" >&2
    exit 1
fi
grep -q a_panic_is_reachable "$results/panics.log" ||
    { cat "$results/panics.log" >&2; echo "FAILED: it is not the panic that keeps it from linking" >&2; exit 1; }
echo "no panic is reachable in the programs for either core, and no allocator is linked"

# Every case by itself on either core, as many at a time as there are processors, the dear ones first: 1e5 steps take long.
part() { # m4 or m7, name of a case
    "$1" "" hashes "$steps" "$2" > "$results/$1-$2.txt"
}
export -f emulate m4 m7 part
export results steps
names=$(awk '!seen[$1]++ {print $1}' "$results/desktop-default.txt")
for name in $(tac <<< "$names"); do
    printf 'm4 %s\nm7 %s\n' "$name" "$name"
done | xargs -P "$(nproc)" -L 1 bash -c 'part "$@" || exit 255' part
for name in $names; do
    cat "$results/m4-$name.txt" >&4
    cat "$results/m7-$name.txt" >&7
done 4> "$results/cortex-m4f.txt" 7> "$results/cortex-m7.txt"
node wasm/run.mjs "$built/wasm32-unknown-unknown/release/wasm.wasm" "$steps" "$@" > "$results/wasm32.txt"

differences=0
for column in desktop-native cortex-m4f cortex-m7 wasm32; do
    if diff "$results/desktop-default.txt" "$results/$column.txt"; then
        echo "$column: the same bits as desktop-default in $(wc -l < "$results/$column.txt") hashes, $steps steps"
    else
        echo "FAILED: $column differs from desktop-default" >&2
        differences=1
    fi
done
[ "$(wc -l < "$results/desktop-default.txt")" -gt 0 ] || { echo "FAILED: no case was run" >&2; exit 1; }

# One step of each with every tick of a 1 kHz timer, at 500 million instructions a second: about an M7 at 480 MHz. An M4F at
# 168 MHz has a third of that, and is late with a slider-crank; `ffrf budget` says by how much.
"$built/$host/release/desktop" loop 200 > "$results/loop.txt"
echo "late 0" >> "$results/loop.txt"
for column in m4 m7; do
    $column "-icount shift=1,sleep=off" loop 200 > "$results/loop-$column.txt" || true
    if diff "$results/loop.txt" "$results/loop-$column.txt"; then
        echo "$column: 200 ticks of a 1 kHz timer, none late, the same bits"
    else
        echo "FAILED: the loop on $column differs from the desktop, or is late" >&2
        differences=1
    fi
done

# Stack at or below the bound of the machine code, with the command of the workspace if it is built.
if [ -x "$ffrf" ]; then
    CARGO=$CARGO FFRF_BUILD_FLAGS=$build_std "$ffrf" budget "$here/../models/conrod.ffrf.json" --modes 4 \
        --target cortex-m4f --scalar f32 --sources "$here/.." --folder "$built/budget" || differences=1
    # a plan for this core, whose instructions are counted where they are predicted
    CARGO=$CARGO FFRF_BUILD_FLAGS=$build_std "$ffrf" plan "$here/../models/scenes/slider_crank.toml" --quantity stroke \
        --target cortex-m4f --clock 1.68e9 --scalar f32 --measure --sources "$here/.." --folder "$built/plan" > "$results/plan.txt"
    grep -F "counted" "$results/plan.txt" || differences=1
    ! grep -F "not counted" "$results/plan.txt" || differences=1
else
    echo "SKIPPED: no budget, $ffrf is not built" >&2
fi
exit $differences
