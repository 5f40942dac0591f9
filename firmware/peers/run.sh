#!/usr/bin/env bash
# Our kernels and C that CasADi generates of the same body, on the same emulated cores: instructions, flash, stack of a call.
# Each as its users compile it (ours by rustc with link-time optimisation, CasADi's C by arm-none-eabi-gcc -O3), and, so that no
# difference is one of compilers, our C by that gcc and CasADi's C by clang, whose code generator is that of rustc.
# Needs what firmware/run.sh sets up, arm-none-eabi-gcc, clang, and python3 with venv and the network for pip. Not part of the check.
# usage: run.sh [MODES...] (default 4 8); writes a table to standard output
set -euo pipefail
folder=$(cd "$(dirname "$0")" && pwd)
here=$(cd "$folder/.." && pwd)
. "$here/toolchain.sh"
command -v arm-none-eabi-gcc > /dev/null || install_packages gcc-arm-none-eabi libnewlib-arm-none-eabi
command -v clang > /dev/null || install_packages clang
work=$here/target/peers
mkdir -p "$work"
model=$here/../models/conrod.ffrf.json
python=${PYTHON:-$work/venv/bin/python}
[ -x "$python" ] || { python3 -m venv "$work/venv" && "$work/venv/bin/pip" install --quiet casadi numpy; }
ffrf=${FFRF:-$here/../target/debug/ffrf}
[ -x "$ffrf" ] || { echo "error: $ffrf is not built, and FFRF names no other" >&2; exit 1; }
[ $# -gt 0 ] || set -- 4 8

program=$here/target/thumbv7em-none-eabihf/release

measure() { # binary, machine, core: `instructions stack code+tables`, results into $work/BINARY.txt
    qemu-system-arm -machine "$2" -cpu "$3" -nographic -monitor none -serial null -icount shift=6 \
        -semihosting-config enable=on,target=native -kernel "$program/$1" > "$work/$1.txt"
    local flash
    flash=$(arm-none-eabi-size -A "$program/$1" | awk '$1 == ".text" || $1 == ".rodata" {sum += $2} END {print sum}')
    awk -v flash="$flash" '$1 == "measured" {print $3, $5, flash}' "$work/$1.txt"
}

build() { # object with the C, binaries...
    local library=$1 bins=() name
    shift
    for name in "$@"; do bins+=(--bin "$name"); done
    # shellcheck disable=SC2086
    PEERS_MODES=$modes PEERS_SCALAR=$scalar PEERS_LIBRARY=$library RUSTFLAGS="-C target-cpu=$core" CARGO_TARGET_DIR=$here/target \
        $CARGO build --quiet --release --target thumbv7em-none-eabihf --manifest-path "$folder/Cargo.toml" "${bins[@]}" $build_std
}

row() { # kernel, who, how it was compiled, binary
    local instructions stack flash
    read -r instructions stack flash <<< "$(measure "$4" "$machine" "$core")"
    echo "| $core | $scalar | $modes | $1 | $2 | $3 | $instructions | $((flash - base)) | $stack |"
}

echo "Compilers: $(rustc --version), $(arm-none-eabi-gcc -dumpversion | sed 's/^/arm-none-eabi-gcc /'), $(clang --version | head -n 1)"
echo
echo "| core | scalar | modes | kernel | of | compiled by | instructions | flash | stack |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for modes in "$@"; do
    "$python" "$folder/body.py" "$model" "$modes" "$work/body.bin"
    "$python" "$here/../benches/peers/casadi_c.py" "$work/body.bin" "$work/casadi.c"
    for target in "mps2-an386 cortex-m4 f32" "mps2-an500 cortex-m7 f32" "mps2-an500 cortex-m7 f64"; do
        read -r machine core scalar <<< "$target"
        fpu=fpv4-sp-d16
        [ "$core" = cortex-m4 ] || fpu=fpv5-d16
        options="-c -O3 -ffp-contract=off -ffunction-sections -mcpu=$core -mthumb -mfloat-abi=hard -mfpu=$fpu"
        real=double
        [ "$scalar" = f64 ] || real=float
        casadi="-Dcasadi_real=$real"
        [ "$scalar" = f64 ] || casadi="$casadi -fsingle-precision-constant"
        sed '/^\(int\|void\) ffrf_/ s/double/casadi_real/g' "$work/casadi.c" > "$work/casadi_$scalar.c"
        # clang knows no such option: it reads the constants as what they then are
        sed -E 's/([0-9]\.[0-9]+e?[-+]?[0-9]*)\b/\1f/g' "$work/casadi_$scalar.c" > "$work/casadi_constants.c"
        [ "$scalar" = f32 ] || cp "$work/casadi_$scalar.c" "$work/casadi_constants.c"
        # shellcheck disable=SC2086
        {
            arm-none-eabi-gcc $options $casadi "$work/casadi_$scalar.c" -o "$work/casadi_gcc.o"
            clang --target=thumbv7em-none-eabihf -isystem /usr/lib/arm-none-eabi/include $options "-Dcasadi_real=$real" \
                "$work/casadi_constants.c" -o "$work/casadi_clang.o"
            "$ffrf" generate "$model" --language c --modes "$modes" --scalar "$scalar" --fma off --layout-tolerance 1e-9 -o "$work/body.c"
            { cat "$work/body.c"; sed "s/\breal\b/$real/g" "$folder/ours.c"; } > "$work/ours_all.c"
            arm-none-eabi-gcc $options -I "$work" "$work/ours_all.c" -o "$work/ours_gcc.o"
        }
        build "$work/casadi_gcc.o" baseline ours_accelerations ours_equations
        read -r _ _ base <<< "$(measure baseline "$machine" "$core")"
        for kernel in accelerations equations; do
            row "$kernel" ours rustc "ours_$kernel"
        done
        for compiled in "ours gcc" "CasADi gcc" "CasADi clang"; do
            read -r who compiler <<< "$compiled"
            build "$work/${who,,}_$compiler.o" c_accelerations c_equations
            for kernel in accelerations equations; do
                row "$kernel" "$who" "$compiler" "c_$kernel"
                "$python" "$folder/same.py" "$scalar" "$work/ours_$kernel.txt" "$work/c_$kernel.txt"
            done
        done
    done
done
