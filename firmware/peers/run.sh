#!/usr/bin/env bash
# Our kernels and C that CasADi generates of the same body, on the same emulated cores: instructions, flash, stack of a call.
# Needs what firmware/run.sh sets up, arm-none-eabi-gcc, and python3 with venv and the network for pip. Not part of the check.
# usage: run.sh [MODES...] (default 4 8); writes a table to standard output
set -euo pipefail
folder=$(cd "$(dirname "$0")" && pwd)
here=$(cd "$folder/.." && pwd)
. "$here/toolchain.sh"
command -v arm-none-eabi-gcc > /dev/null || install_packages gcc-arm-none-eabi libnewlib-arm-none-eabi
work=$here/target/peers
mkdir -p "$work"
python=${PYTHON:-$work/venv/bin/python}
[ -x "$python" ] || { python3 -m venv "$work/venv" && "$work/venv/bin/pip" install --quiet casadi numpy; }
[ $# -gt 0 ] || set -- 4 8

measure() { # binary, machine, core: `instructions stack code+tables`, results into $work/BINARY.txt
    qemu-system-arm -machine "$2" -cpu "$3" -nographic -monitor none -serial null -icount shift=6 \
        -semihosting-config enable=on,target=native -kernel "$program/$1" > "$work/$1.txt"
    local flash
    flash=$(arm-none-eabi-size -A "$program/$1" | awk '$1 == ".text" || $1 == ".rodata" {sum += $2} END {print sum}')
    awk -v flash="$flash" '$1 == "measured" {print $3, $5, flash}' "$work/$1.txt"
}

echo "| core | scalar | modes | kernel | | instructions | flash | stack |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- |"
for modes in "$@"; do
    "$python" "$folder/body.py" "$here/../models/conrod.ffrf.json" "$modes" "$work/body.bin"
    "$python" "$here/../benches/peers/casadi_c.py" "$work/body.bin" "$work/casadi.c"
    for target in "mps2-an386 cortex-m4 f32" "mps2-an500 cortex-m7 f32" "mps2-an500 cortex-m7 f64"; do
        read -r machine core scalar <<< "$target"
        floats=-Dcasadi_real=double
        [ "$scalar" = f64 ] || floats="-Dcasadi_real=float -fsingle-precision-constant"
        sed '/^\(int\|void\) ffrf_/ s/double/casadi_real/g' "$work/casadi.c" > "$work/casadi_$scalar.c"
        fpu=fpv4-sp-d16
        [ "$core" = cortex-m4 ] || fpu=fpv5-d16
        # shellcheck disable=SC2086
        arm-none-eabi-gcc -c -O3 -ffp-contract=off -ffunction-sections $floats -mcpu=$core -mthumb -mfloat-abi=hard -mfpu=$fpu \
            "$work/casadi_$scalar.c" -o "$work/casadi.o"
        program=$here/target/thumbv7em-none-eabihf/release
        # shellcheck disable=SC2086
        PEERS_MODES=$modes PEERS_SCALAR=$scalar PEERS_LIBRARY=$work/casadi.o RUSTFLAGS="-C target-cpu=$core" \
            CARGO_TARGET_DIR=$here/target $CARGO build --quiet --release --target thumbv7em-none-eabihf \
            --manifest-path "$folder/Cargo.toml" $build_std
        read -r _ _ base <<< "$(measure baseline "$machine" "$core")"
        for kernel in accelerations equations; do
            for who in ours casadi; do
                read -r instructions stack flash <<< "$(measure "${who}_$kernel" "$machine" "$core")"
                echo "| $core | $scalar | $modes | $kernel | $who | $instructions | $((flash - base)) | $stack |"
            done
            "$python" "$folder/same.py" "$scalar" "$work/ours_$kernel.txt" "$work/casadi_$kernel.txt"
        done
    done
done
