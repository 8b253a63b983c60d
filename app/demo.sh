#!/usr/bin/env bash
# Everything from a bare Debian 12 to the first result: installs packages, builds the release preset, runs `nadir demo`.
# Arguments go to `nadir demo` (for example --seed 3 --out FOLDER).
set -euo pipefail
cd "$(dirname "$0")/.."

bash app/install_packages.sh app/packages.txt
[ -f build/release/build.ninja ] || cmake --preset release >/dev/null
cmake --build --preset release
exec build/release/bin/nadir demo "$@"
