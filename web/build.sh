#!/usr/bin/env bash
# Makes the page, static files for any server: `web/build.sh`, then `python3 -m http.server -d web/dist`.
# Needs the target wasm32-unknown-unknown of rustup, and npm, which fetches three.js and what bundles it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here"
. ./module.sh
mkdir -p dist
cp "$module" dist/engine.wasm
# The looks of the rod, from its finite-element model by the command itself.
cargo run --quiet --manifest-path ../Cargo.toml --package ffrf-cli --bin ffrf -- \
    reduce --calculix ../models/conrod/conrod.inp --modes 8 --marker BIG_END=BIG_END --marker SMALL_END=SMALL_END \
    --view dist/rod.glb -o dist/rod.ffrf.json > /dev/null
npm ci --silent --no-audit --no-fund
npx esbuild page/page.js --bundle --minify --format=esm --log-level=warning --outfile=dist/page.js
cp page/index.html page/page.css dist/
cp node_modules/three/LICENSE dist/three.LICENSE
echo "written: $here/dist ($(du -sh dist | cut -f1))"
