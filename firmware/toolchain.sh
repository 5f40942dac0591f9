# Sourced: a compiler for thumbv7em-none-eabihf and wasm32-unknown-unknown, the emulator and node, whatever is missing of them.
# Sets CARGO, build_std (flags for targets that the compiler has no library for) and exports RUSTC and PATH if need be.
# FFRF_TOOLCHAIN=rustup or debian chooses the way; without it, rustup is tried first.

wanted="thumbv7em-none-eabihf wasm32-unknown-unknown"
toolchain_folder=${FFRF_TOOLCHAIN_FOLDER:-$here/target/toolchain}

privileged() { # as root, or through sudo
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi
}

install_packages() { # Debian packages by name
    echo "installing $*"
    command -v apt-get > /dev/null || { echo "error: $* are missing, and there is no apt-get to install them" >&2; return 1; }
    { privileged apt-get update && privileged apt-get install -y --no-install-recommends "$@"; } > "$here/target/apt.log" 2>&1 ||
        { tail -n 5 "$here/target/apt.log" >&2; echo "error: apt-get could not install $*" >&2; return 1; }
}

have_targets() {
    local installed
    installed=$(rustup target list --installed 2> /dev/null) || return 1
    for name in $wanted; do
        grep -qx "$name" <<< "$installed" || return 1
    done
}

# The library source of Debian's compiler, unpacked beside the system: its library is built with the program.
debian_toolchain() {
    local library
    if [ ! -x "$toolchain_folder/root/usr/bin/rustc" ]; then
        mkdir -p "$toolchain_folder"
        { privileged apt-get update > /dev/null && cd "$toolchain_folder" &&
            library=$(apt-cache depends libstd-rust-web-dev | awk '/libstd-rust-web-[0-9]/ {print $2; exit}') &&
            apt-get download rustc-web rust-web-src libstd-rust-web-dev "$library" rust-web-llvm > download.log 2>&1; } ||
            { echo "error: Debian's compiler could not be downloaded, see $toolchain_folder/download.log" >&2; return 1; }
        local package
        for package in "$toolchain_folder"/*.deb; do
            dpkg -x "$package" "$toolchain_folder/root"
        done
        cd - > /dev/null
    fi
    export LD_LIBRARY_PATH=$toolchain_folder/root/usr/lib/x86_64-linux-gnu
    library=$(ldd "$toolchain_folder/root/usr/bin/rustc" | awk '/libLLVM.*not found/ {print $1; exit}')
    if [ -n "$library" ]; then
        # libLLVM.so.22.1 or libLLVM-22.so is in the package libllvm22
        install_packages "libllvm$(sed -E 's/^libLLVM[^0-9]*([0-9]+).*/\1/' <<< "$library")"
    fi
    local linkers
    linkers=$(rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin # rust-lld of the stable toolchain
    CARGO=$(rustup which cargo)
    export PATH=$linkers:$PATH RUSTC=$toolchain_folder/root/usr/bin/rustc RUSTC_BOOTSTRAP=1
    build_std=-Zbuild-std=core
}

mkdir -p "$here/target"
CARGO=cargo
build_std=
case ${FFRF_TOOLCHAIN:-} in
    debian) debian_toolchain ;;
    rustup) have_targets || timeout 120 rustup target add $wanted ;;
    "")
        if ! have_targets && ! timeout 120 rustup target add $wanted > "$here/target/rustup.log" 2>&1; then
            echo "rustup has no library for $wanted here; taking Debian's compiler"
            debian_toolchain
        fi
        ;;
    *) echo "error: FFRF_TOOLCHAIN=$FFRF_TOOLCHAIN: expected rustup or debian" >&2; exit 2 ;;
esac
missing=
command -v qemu-system-arm > /dev/null || missing="$missing qemu-system-arm"
command -v node > /dev/null || missing="$missing nodejs"
[ -z "$missing" ] || install_packages $missing
