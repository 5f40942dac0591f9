#!/bin/sh
# The hinge of Exudyn's tutorial on component modes: our frequencies beside the published ones.
# Usage: [FFRF=built_command] [PYTHON=with_netgen] [EDGES="0.01:1 0.01:2"] hinge.sh
#   EDGES  largest edge in m, and the order of the tetrahedra behind a colon. Netgen is installed into a temporary folder without PYTHON.
# Published (docs of Exudyn, "Model order reduction and component mode synthesis"): 1216 nodes, tetrahedra of 4 nodes.
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python=${PYTHON:-}
if [ -z "$python" ]; then
    python3 -m venv "$work/venv"
    "$work/venv/bin/pip" install --quiet netgen-mesher ngsolve
    python="$work/venv/bin/python"
fi
ffrf=${FFRF:-}
if [ -z "$ffrf" ]; then
    cargo build --release --quiet -p ffrf-cli
    ffrf="${CARGO_TARGET_DIR:-target}/release/ffrf"
fi
frequencies() { printf '| %s |' "$1"; shift; for f in "$@"; do printf ' %s |' "$f"; done; printf '\n'; }
echo "| free-free | f/Hz | | | | | | | |"
echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
frequencies "Exudyn, 1216 nodes, published" 671.59 707.17 1298.50 1929.97 1971.76 3141.47 3595.34 4317.51
frequencies "Exudyn, fine mesh, published" 371.50 - - - - - - -
for case in ${EDGES:-0.01:1 0.01:2}; do
    edge=${case%:*} order=${case#*:}
    size=$("$python" benches/peers/hinge_mesh.py "$work/hinge$case.msh" "$edge" "$order")
    "$ffrf" reduce "$work/hinge$case.msh" --material 7850,2.1e11,0.3 --modes 8 -o "$work/body.json" >/dev/null
    frequencies "ffrf, edge $edge m, order $order, $size" $(tr -d ' \n' <"$work/body.json" | grep -o '"frequency_hz":[0-9.e+-]*' | cut -d: -f2 |
        awk '{ printf "%.2f ", $1 }')
done
echo
echo "| both ends held (Craig-Bampton) | f/Hz | | | |"
echo "| --- | ---: | ---: | ---: | ---: |"
frequencies "Exudyn, 1216 nodes, published" 1277.35 1469.86 3336.91 3584.28
for case in ${EDGES:-0.01:1 0.01:2}; do
    "$ffrf" reduce "$work/hinge$case.msh" --material 7850,2.1e11,0.3 --modes 4 -o "$work/body.json" \
        --interface BOLT=cylinder:0,0,0,0,1,0,0.015,1e-6 --interface BUSHING=cylinder:0.4,0,0,0,1,0,0.015,1e-6 >"$work/report"
    frequencies "ffrf, edge ${case%:*} m, order ${case#*:}" $(sed -n '/^normal modes that entered/,/^mode /p' "$work/report" | sed '1d;$d' |
        sed 's/([^)]*)//g' | awk '{ for (i = 1; i <= NF; i++) printf "%.2f ", $i }')
done
