#!/bin/bash
# Our mechanisms against Exudyn (work-precision), MuJoCo, Pinocchio and a dense solve (chains), see mechanisms/README.md.
# Environment:
#   WORK     scratch folder, everything is installed there (default: a new temporary one)
#   EXPORTS  folder with rotorDiscTest.inp, ...MASS1.mtx and ...STIF1.mtx (default: ../shared/fe-exports beside the workspace)
#   PARTS    what to run (default: "work_precision chains agreement")        CPU  core to stay on (default: 1)
#   PASSES   turns of all columns (default: 3)    ROUNDS  runs of each in a turn, the least counts (default: 3; chains: 30 times as many)
#            (results of parts that are not run stay as they are, with the date and load of their own)
#   FFRF     the command `ffrf`, if it is built already            OUT  where results go (default: mechanisms/)
set -u
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../.." && pwd)
export WORK=${WORK:-$(mktemp -d)}
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$WORK/cargo} FFRF_BODIES=$WORK/bodies
exports=${EXPORTS:-$root/../shared/fe-exports} parts=${PARTS:-work_precision chains agreement}
passes=${PASSES:-3} rounds=${ROUNDS:-3} out=${OUT:-$here/mechanisms} cpu=${CPU:-1}
source=$here/mechanisms numbers="1 2 4 8 16 32 64"
mkdir -p "$FFRF_BODIES" "$out"

python=$WORK/venv/bin/python
if [ ! -x "$python" ]; then
    python3 -m venv "$WORK/venv" && "$WORK/venv/bin/pip" install --quiet numpy matplotlib exudyn || exit 1
fi
packages=$("$python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
# on a machine that others use as well, ask for precedence; without the right to do so, do without
run="taskset -c $cpu nice -n -20"
nice -n -20 true 2> /dev/null || run="taskset -c $cpu"

if [ -z "${FFRF:-}" ]; then
    cargo build --release --quiet --manifest-path "$root/Cargo.toml" -p ffrf-cli || exit 1
    FFRF=$CARGO_TARGET_DIR/release/ffrf
fi
"$python" "$source/simeon_body.py" "$FFRF_BODIES" || exit 1
cases=slider_crank features=
if [ -f "$exports/rotorDiscTest.inp" ]; then
    if "$python" "$source/rotor_body.py" "$exports" "$FFRF_BODIES" "$FFRF" > "$WORK/rotor.log" 2>&1; then
        cases="rotor slider_crank" features=rotor
    else
        tail -n 3 "$WORK/rotor.log" >&2
        exit 1
    fi
else
    echo "SKIPPED: rotor: no $exports/rotorDiscTest.inp" >&2
fi
RUSTFLAGS="-C target-cpu=native" cargo build --release --quiet --manifest-path "$source/ours/Cargo.toml" --features "$features" || exit 1

for part in $parts; do
    case $part in
    work_precision)
        $run "$python" "$source/work_precision.py" "$FFRF_BODIES" "$CARGO_TARGET_DIR/release/work_precision" "$WORK" \
            "$passes" "$rounds" $cases || exit 1
        ;;
    chains)
        columns=("$CARGO_TARGET_DIR/release/chains $((30 * rounds))")
        if "$WORK/venv/bin/pip" install --quiet mujoco > "$WORK/mujoco.log" 2>&1 \
            && gcc -O3 -march=native -I"$packages/mujoco/include" -o "$WORK/pendulum_mujoco" "$source/pendulum_mujoco.c" \
                "$packages"/mujoco/libmujoco.so.* -lm -Wl,-rpath,"$packages/mujoco" >> "$WORK/mujoco.log" 2>&1; then
            "$python" "$source/pendulum_xml.py" "$WORK" $numbers
            arguments=
            for n in $numbers; do arguments="$arguments $WORK/pendulum_$n.xml $n"; done
            columns+=("$WORK/pendulum_mujoco $((30 * rounds))$arguments")
        else
            echo "SKIPPED: MuJoCo: $(tail -n 1 "$WORK/mujoco.log")" >&2
        fi
        # its headers take minutes to compile; the limit is what its own build sets for its 25 kinds of joints
        if [ -x "$WORK/pendulum_pinocchio" ] || {
            "$WORK/venv/bin/pip" install --quiet pin cmeel-eigen > "$WORK/pinocchio.log" 2>&1 \
            && g++ -std=c++17 -O3 -march=native -DNDEBUG -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -DBOOST_MPL_LIMIT_LIST_SIZE=30 \
                -I"$packages/cmeel.prefix/include" -isystem "$packages/cmeel.prefix/include/eigen3" -o "$WORK/pendulum_pinocchio" "$source/pendulum_pinocchio.cpp" \
                -L"$packages/cmeel.prefix/lib" -lpinocchio_default -Wl,-rpath,"$packages/cmeel.prefix/lib" \
                >> "$WORK/pinocchio.log" 2>&1; }; then
            columns+=("$WORK/pendulum_pinocchio $((30 * rounds)) $numbers")
        else
            echo "SKIPPED: Pinocchio: $(grep -i -m 1 error "$WORK/pinocchio.log")" >&2
        fi
        : > "$WORK/chains.jsonl"
        for pass in $(seq "$passes"); do
            echo "chains: pass $pass of $passes"
            for column in "${columns[@]}"; do $run $column >> "$WORK/chains.jsonl" || exit 1; done
        done
        ;;
    agreement) "$python" "$source/agreement.py" "$FFRF" "$WORK" "$out" || exit 1 ;;
    *) echo "unknown part $part" >&2; exit 1 ;;
    esac
done
"$python" "$source/report.py" "$WORK" "$out" "$parts" "PARTS=\"$parts\" PASSES=$passes ROUNDS=$rounds benches/peers/mechanisms.sh"
