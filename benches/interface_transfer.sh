#!/bin/sh
# Interface transfer functions of reduced parts against the full finite-element models: error over frequency for each basis.
# Usage: [FFRF=built_command] [EXPORTS=folder] interface_transfer.sh > benches/interface_transfer.md
#   The rod of models/conrod and the rotor of models/rotor; pictures go to docs/pictures/transfer_*.svg.
#   EXPORTS  folder with rotorDiscTest.inp, ...MASS1.mtx and ...STIF1.mtx (default: ../shared/fe-exports beside the workspace): a
#            real rotor is compared too, its table printed and its picture left in the folder for temporary files.
set -eu
cd "$(dirname "$0")/.."
ffrf=${FFRF:-}
if [ -z "$ffrf" ]; then
    cargo build --release --quiet -p ffrf-cli
    ffrf="${CARGO_TARGET_DIR:-target}/release/ffrf"
fi
exports=${EXPORTS:-../shared/fe-exports}
work=$(mktemp -d)

# compare TITLE PICTURE LIMIT WORDS...: a picture of a hundred frequencies, a table of every tenth
compare() {
    title=$1 picture=$2 limit=$3
    shift 3
    printf '## %s\n\n    ffrf reduce' "$title"
    for word in "$@"; do printf ' %s' "$word"; done
    printf ' --transfer-up-to %s --transfer-points 100 --transfer-bases all --transfer-plot transfer.svg\n\n' "$limit"
    "$ffrf" reduce "$@" --transfer-up-to "$limit" --transfer-points 100 --transfer-bases all --transfer-plot "$picture" \
        -o "$work/body.json" >"$work/report"
    sed -n '/^interface /p' "$work/report" | sed 's/^interface /- interface /'
    sed -n '/^normal modes that entered/,/^mode  kind/p' "$work/report" | sed '1d;$d' | sed 's/([^)]*)//g' | awk 'NF { last = $NF }
        END { printf "- highest normal mode of the Craig-Bampton basis: %.0f Hz\n\n", last }'
    sed -n '/^error of the interface/,$p' "$work/report" | grep '^|' | awk 'NR <= 2 || (NR - 2) % 10 == 0'
    echo
}

cat <<'HEAD'
# Interface transfer functions for each basis

Made by `benches/interface_transfer.sh`. Every basis has as many modes as the Craig-Bampton one, so that all bodies cost the same. The error is the
norm of the difference of the elastic receptance H(ω) = B (K - ω²M)⁻¹ Bᵀ of all interface motions over that of the full model, each
motion scaled by its static compliance: 1 means that nothing is right. Nothing is damped; near a resonance a small shift of frequency is a large error.

HEAD
compare "Connecting rod, 1232 nodes" docs/pictures/transfer_rod.svg 12000 \
    --calculix models/conrod/conrod.inp --interface BIG_END=set:BIG_END,rbe2 --interface SMALL_END=set:SMALL_END,rbe2 --modes 16
echo '![Errors of the rod](../docs/pictures/transfer_rod.svg)'
echo
compare "Rotor with two discs, 1389 nodes" docs/pictures/transfer_rotor.svg 3000 \
    models/rotor/rotor.msh.gz --material 7850,2.1e11,0.3 \
    --interface LEFT=plane:0.04,0,0,1,0,0 --interface RIGHT=plane:0.56,0,0,1,0,0 --modes 16
echo '![Errors of the rotor](../docs/pictures/transfer_rotor.svg)'
if [ -f "$exports/rotorDiscTest.inp" ]; then
    echo
    # The ends of the shaft, by their places along z.
    compare "A rotor exported from Abaqus (not part of the repository)" "$work/transfer_export.svg" 3000 \
        --abaqus "$exports/rotorDiscTest.inp" --mass "$exports/rotorDiscTestMASS1.mtx" --stiffness "$exports/rotorDiscTestSTIF1.mtx" \
        --interface LEFT=plane:0,0,0,0,0,1 --interface RIGHT=plane:0,0,0.5,0,0,1 --modes 16 >&2
    echo "picture: $work/transfer_export.svg" >&2
else
    echo "SKIPPED: no $exports/rotorDiscTest.inp" >&2
fi
