#!/usr/bin/env bash
# A step of a mechanism in our generated C on emulated cores: instructions, flash, stack; `ffrf budget` has those of the Rust step.
# Needs what firmware/run.sh sets up, and arm-none-eabi-gcc. Not part of the check.
# usage: step.sh [SCENE] [-O2|-O3...] (default: the slider-crank, -O2 and -O3); writes a table to standard output
set -euo pipefail
folder=$(cd "$(dirname "$0")" && pwd)
here=$(cd "$folder/.." && pwd)
. "$here/toolchain.sh"
command -v arm-none-eabi-gcc > /dev/null || install_packages gcc-arm-none-eabi libnewlib-arm-none-eabi
scene=${1:-$here/../models/scenes/slider_crank.toml}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- -O2 -O3
ffrf=${FFRF:-$here/../target/debug/ffrf}
[ -x "$ffrf" ] || { echo "error: $ffrf is not built, and FFRF names no other" >&2; exit 1; }
work=$here/target/step
mkdir -p "$work"

echo "Compiler: arm-none-eabi-gcc $(arm-none-eabi-gcc -dumpversion)"
echo
echo "| core | scalar | compiled with | instructions | stack (bytes) | flash (bytes) |"
echo "| --- | --- | --- | --- | --- | --- |"
for target in "mps2-an500 cortex-m7 fpv5-d16 f64" "mps2-an500 cortex-m7 fpv5-d16 f32" "mps2-an386 cortex-m4 fpv4-sp-d16 f32"; do
    read -r machine core fpu scalar <<< "$target"
    "$ffrf" generate "$scene" --language c --name Mechanism --scalar "$scalar" -o "$work/mechanism.c" > /dev/null
    for level in "$@"; do
        options="-std=c99 $level -ffp-contract=off -ffunction-sections -mcpu=$core -mthumb -mfloat-abi=hard -mfpu=$fpu -I $work"
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $options -nostartfiles -Wl,--gc-sections -T "$folder/step.ld" "$folder/step.c" "$work/mechanism.c" -lm \
            -o "$work/step.elf"
        qemu-system-arm -machine "$machine" -cpu "$core" -nographic -monitor none -serial null -icount shift=6 \
            -semihosting-config enable=on,target=native -kernel "$work/step.elf" > "$work/counted.txt" 2>&1
        read -r _ instructions _ stack _ answer < "$work/counted.txt"
        [ "$answer" = 0 ] || { echo "error: a step was refused: $answer" >&2; exit 1; }
        flash=$(arm-none-eabi-size -A "$work/step.elf" | awk '$1 == ".text" || $1 == ".rodata" {sum += $2} END {print sum}')
        echo "| $core | $scalar | gcc $level | $instructions | $stack | $flash |"
    done
done
