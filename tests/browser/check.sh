#!/usr/bin/env bash
# Do the pages work in a browser? Builds a small book with mdBook and looks at it in Chromium.
#
# Needs node, Chromium (in CHROMIUM, or found on PATH), and two packages of npm, which are installed below target/. Ends with
# 77 where they are not there.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$PWD/target/browser

skip() { echo "skipped: $*"; exit 77; }
command -v node >/dev/null || skip "there is no node"
CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
[ -x "$CHROMIUM" ] || skip "there is no Chromium; name it in CHROMIUM"
mkdir -p "$target"
if ! cmp -s tests/browser/package-lock.json "$target/package-lock.json" || [ ! -d "$target/node_modules/playwright-core" ]; then
  cp tests/browser/package.json tests/browser/package-lock.json "$target/"
  if ! npm ci --prefix "$target" --no-audit --no-fund >"$target/npm.log" 2>&1; then
    rm "$target/package-lock.json"
    tail -3 "$target/npm.log"
    skip "the packages of tests/browser/package.json cannot be had"
  fi
fi

# as `cargo test` builds them; other options of cargo, such as --all-features, may follow the script
cargo build --quiet --locked --profile test --bin raystep --example browser_book "$@"
rm -rf "$target/book"
target/debug/examples/browser_book target/debug/raystep "$target/book"
rm -rf "$target/pages"
mkdir "$target/pages"
raystep() { target/debug/raystep --quiet "$@"; }
lessons=tests/browser/book/lessons
raystep inspect $lessons/01-ball/ball.json --region 3,4-4,5 -o "$target/pages/ball.html"
raystep inspect $lessons/02-names/names.json 4,4 -o "$target/pages/names.html"
raystep trace lessons/08-transport/powered.json --transport hybrid-connected --region 30,16 -o "$target/pages/light.jsonl"
raystep inspect "$target/pages/light.jsonl" 30,16 -o "$target/pages/light.html"
export CHROMIUM BOOK=$target/book PAGES=$target/pages BROWSER_PACKAGES=$target
node --test tests/browser/
