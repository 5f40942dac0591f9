#!/usr/bin/env bash
# Builds the wheel as `pip install ./ffrf-python` does and runs its tests, in an environment of its own below the target folder.
# Needs python3 (3.9 or later) and PyPI; says so and does nothing where PyPI cannot be reached.
# Arguments go to pytest: ffrf-python/test.sh -k simulate
set -euo pipefail
cd "$(dirname "$0")"

export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/../target}
place=$CARGO_TARGET_DIR/python
python=$place/bin/python
log=$place/pip.log

skip() {
    printf '\nSKIPPED: the Python package is NOT tested: %s\n\n' "$1"
    exit 0
}

# What pip says where there is no network; every other failure is one.
is_offline() {
    grep -qiE 'NewConnectionError|name resolution|Network is unreachable|Connection refused|ConnectTimeout|Read timed out|ProxyError' "$log"
}

command -v "${PYTHON:-python3}" >/dev/null || skip "there is no python3"
mkdir -p "$place"
if ! "${PYTHON:-python3}" -m venv "$place" >"$log" 2>&1; then
    # Debian keeps what venv needs in a package of its own
    { [ "$(id -u)" = 0 ] && apt-get update && apt-get install -y --no-install-recommends python3-venv; } >>"$log" 2>&1 || true
    "${PYTHON:-python3}" -m venv "$place" >>"$log" 2>&1 || skip "python3 cannot make an environment, see $log"
fi
if ! "$python" -m pip install --disable-pip-version-check --retries 2 -r tests/requirements.txt >"$log" 2>&1; then
    is_offline && skip "PyPI cannot be reached"
    cat "$log"
    exit 1
fi

rm -rf "$place/wheels"
"$python" -m maturin build --quiet --profile "${FFRF_WHEEL_PROFILE:-release}" --locked -i "$python" -o "$place/wheels"
# one wheel for all versions of Python
ls "$place"/wheels/ffrf-*-cp39-abi3-*.whl >/dev/null
"$python" -m pip install --disable-pip-version-check --quiet --no-deps --force-reinstall "$place"/wheels/*.whl

# Stubs say what is there, and examples and tests are typed by them.
"$python" -m mypy.stubtest ffrf
"$python" -m mypy --cache-dir "$place/mypy" examples tests
"$python" -m pytest -q -p no:cacheprovider "$@"
