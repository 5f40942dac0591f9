#!/bin/sh
# Makes everything in this folder anew: mesh, decks, CalculiX export, CalculiX's own frequencies.
# Needs python3 (no packages) and CalculiX 2.20 (`apt-get install calculix-ccx`); installs nothing.
# Running it again gives the same bytes on the same machine: `git status` then shows no change.
set -eu
here=$(cd "$(dirname "$0")" && pwd)

for tool in python3 ccx gzip; do
    command -v "$tool" >/dev/null || { echo "remake.sh: $tool not found (Debian: apt-get install python3 calculix-ccx gzip)" >&2; exit 1; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1

python3 "$here/mesh.py" "$work"
cd "$work"
for deck in conrod conrod_frequencies; do
    ccx "$deck" >"$deck.log" 2>&1 || { tail -n 20 "$deck.log" >&2; exit 1; }
done
for file in conrod.sti conrod.mas conrod.dof conrod_frequencies.dat; do
    [ -s "$file" ] || { echo "remake.sh: CalculiX did not write $file" >&2; tail -n 20 conrod.log >&2; exit 1; }
done

# -n: without name and time, so that the same data gives the same bytes
gzip -9 -n conrod.sti conrod.mas
cp conrod.inp conrod_frequencies.inp conrod.dof conrod.sti.gz conrod.mas.gz "$here/"
# the table of frequencies only; the participation factors of the rigid-body modes depend on rounding
sed -n '/E I G E N V A L U E/,/P A R T I C I P A T I O N/p' conrod_frequencies.dat | sed '$d' >"$here/conrod_frequencies.txt"
du -ch "$here"/conrod* | tail -n 1
