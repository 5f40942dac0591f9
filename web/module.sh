# Sourced in this folder: builds the module of WebAssembly; $module is its path.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/../target}
if command -v rustup > /dev/null && ! rustup target list --installed | grep -qx wasm32-unknown-unknown; then
    timeout 120 rustup target add wasm32-unknown-unknown || {
        echo "SKIPPED: rustup has no library for wasm32-unknown-unknown here, and no module was built" >&2
        exit "${without_target:-1}"
    }
fi
cargo build --quiet --release --locked --target wasm32-unknown-unknown
module=$CARGO_TARGET_DIR/wasm32-unknown-unknown/release/web.wasm
