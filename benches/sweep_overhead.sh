#!/bin/sh
# How busy a sweep of 1,020 configurations of the tumbling rod keeps the cores, and what it takes beside its runs.
#
#     benches/sweep_overhead.sh [FOLDER]        # a minute on two idle cores; on a busy machine only processor times say something
#     FFRF=COMMAND benches/sweep_overhead.sh    # a command that is built already
#
# busy: processor time over wall time and cores, of the whole command, reference and writing included.
# overhead: processor time that is neither the reference's nor the runs', over that of the runs, which table.csv has.
# serial: processor time of a command that finds every run and the reference in the folder: reading, tables, pictures, page.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
folder=${1:-$(mktemp -d)}
ffrf=${FFRF:-${CARGO_TARGET_DIR:-$here/target}/release/ffrf}
[ -n "${FFRF:-}" ] || cargo build --release --quiet --manifest-path "$here/Cargo.toml" -p ffrf-cli
cores=$(getconf _NPROCESSORS_ONLN)
steps=0.1,0.07,0.05,0.035,0.025,0.018,0.0125,0.009,0.0063,0.0045,0.0032,0.0023,0.0016,0.0011,0.0008,0.0006,0.0003
scene=$here/models/scenes/tumbling_rod.toml

# wall, user and system time (s) of a command, to the file that is named first
timed() {
    to=$1
    shift
    LC_ALL=C bash -c 'TIMEFORMAT="%R %U %S"; time "$@" > /dev/null 2> /dev/null' timed "$@" 2> "$to"
}

sweep() {
    timed "$1" "$ffrf" tradeoff "$scene" -o "$2" --modes "$3" --step "$4" --quantity tip --fidelity constant,linear,full
}

rm -rf "$folder/all" "$folder/reference"
mkdir -p "$folder"
sweep "$folder/reference.time" "$folder/reference" 0 0.1
sweep "$folder/all.time" "$folder/all" 0,1,2,4 "$steps"
sweep "$folder/again.time" "$folder/all" 0,1,2,4 "$steps"
duration=$(awk '$1 == "duration" { print $3; exit }' "$scene")
runs=$(awk -F, -v duration="$duration" 'NR > 1 && $9 != "" { sum += $9 * duration } END { print sum }' "$folder/all/table.csv")
count=$(($(wc -l < "$folder/all/table.csv") - 1))
awk -v cores="$cores" -v runs="$runs" -v count="$count" '
    FILENAME ~ /reference.time/ { reference = $2 + $3; wall_of_reference = $1 }
    FILENAME ~ /all.time/ { processor = $2 + $3; wall = $1 }
    FILENAME ~ /again.time/ { serial = $2 + $3 }
    END {
        printf "%d configurations, %d cores: %.2f s wall, %.2f s processor, busy %.1f %%\n", count, cores, wall, processor, 100 * processor / wall / cores
        printf "reference: %.2f s processor in %.2f s\n", reference, wall_of_reference
        printf "runs that reached their end, as table.csv has them: %.2f s\n", runs
        printf "overhead over them, with failed runs in it: %.1f %%\n", 100 * (processor - reference - runs) / runs
        printf "serial: %.2f s processor, %.1f %% of all\n", serial, 100 * serial / processor
    }' "$folder/reference.time" "$folder/all.time" "$folder/again.time"
