#!/usr/bin/env bash
# Are logs, words and figures of the core the same on WebAssembly as on this machine, byte for byte?
#
# Needs node, and either rustup's target (rustup target add wasm32-unknown-unknown), or Debian's rustc-web, cargo-web,
# rust-web-src and lld, which build the standard library for it. Ends with 77 where there is neither.
set -euo pipefail
cd "$(dirname "$0")"
target=$(cd ../.. && pwd)/target/wasm

command -v node >/dev/null || { echo "skipped: there is no node"; exit 77; }
build=(cargo build --release --lib --target wasm32-unknown-unknown)
if rustc --print target-libdir --target wasm32-unknown-unknown 2>/dev/null | xargs -r ls >/dev/null 2>&1; then
  "${build[@]}" --target-dir "$target"
elif linker=$(ls /usr/bin/wasm-ld-* 2>/dev/null | tail -1) && [ -n "$linker" ] && [ -d /usr/lib/rustlib/src ] || [ -d /usr/src/rustc-web ]; then
  RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$(basename "$linker") \
    /usr/bin/"${build[@]}" --target-dir "$target" -Z build-std=std,panic_abort
else
  echo "skipped: neither rustup's target wasm32-unknown-unknown nor Debian's rustc-web is installed"
  exit 77
fi
cargo run --quiet --release --bin native --target-dir "$target/native" > "$target/native.txt"
node lines.mjs "$target/wasm32-unknown-unknown/release/raystep_wasm.wasm" > "$target/wasm.txt"
if ! diff "$target/native.txt" "$target/wasm.txt" > "$target/difference.txt"; then
  head -20 "$target/difference.txt"
  echo "of $(wc -l < "$target/native.txt") cases, $(grep -c '^<' "$target/difference.txt") differ"
  exit 1
fi
echo "$(wc -l < "$target/native.txt") cases are the same"
