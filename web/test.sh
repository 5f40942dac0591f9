#!/usr/bin/env bash
# The page in a browser without a window: every motion runs, keeps its energy, and a user's own body is taken. Writes pictures to
# dist/pictures, to be looked at. Needs chromium; without it, only the module is run, by node, and that is said.
# usage: test.sh [--module]: the module alone, without npm and browser
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here"
if [ "${1:-}" = --module ]; then
    without_target=0 # where the firmware takes another compiler for it, this is left out, loudly
    . ./module.sh
    node check.mjs "$module" ../models/spin_up_beam.ffrf.json
    exit
fi
./build.sh
node check.mjs dist/engine.wasm ../models/spin_up_beam.ffrf.json
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -z "$browser" ]; then
    echo "SKIPPED: no chromium, the page was not opened" >&2
    exit 0
fi
scratch=$(mktemp -d)
python3 -u -m http.server 0 --bind 127.0.0.1 --directory dist > "$scratch/server.log" 2>&1 &
server=$!
trap 'kill $server; rm -rf "$scratch"' EXIT
for _ in $(seq 50); do
    port=$(sed -nE 's/.*port ([0-9]+).*/\1/p' "$scratch/server.log")
    [ -n "$port" ] && break
    sleep 0.1
done
open() { # query, options...
    local query=$1
    shift
    timeout 120 "$browser" --headless --no-sandbox --user-data-dir="$scratch/profile" --use-gl=angle --use-angle=swiftshader \
        --enable-unsafe-swiftshader --window-size=1200,750 --virtual-time-budget=6000 "$@" "http://127.0.0.1:$port/index.html$query" \
        2> "$scratch/browser.log"
}
open "?check&own=rod.ffrf.json,rod.glb" --dump-dom > "$scratch/page.html"
python3 - "$scratch/page.html" <<'P'
import html, json, re, sys
page = open(sys.argv[1]).read()
if 'data-ready="yes"' not in page:
    sys.exit("FAILED: the page did not become ready: " + re.sub("<[^>]*>", " ", page)[-500:])
lines = json.loads(html.unescape(re.search(r'<pre id="check"[^>]*>(.*?)</pre>', page, re.S).group(1)))
bad = [line for line in lines if not line["drift"] < (1e-3 if line["scalar"] == "f64" else 1e-2)]
scenes = {line["scene"] for line in lines}
if bad or len(lines) < 45 or len(scenes) != 3:
    sys.exit(f"FAILED: {len(lines)} motions of {sorted(scenes)}, of which lost their energy: {bad}")
print(f"in the browser: {len(lines)} motions of {', '.join(sorted(scenes))} kept their energy")
P
mkdir -p dist/pictures
for query in "scene=0&time=0.0125" "scene=1&time=0.0125" "own=rod.ffrf.json,rod.glb" "own=rod.ffrf.json"; do
    name=$(tr -c 'a-z0-9\n' _ <<< "$query")
    open "?$query" --screenshot="dist/pictures/$name.png"
done
echo "written: $here/dist/pictures"
