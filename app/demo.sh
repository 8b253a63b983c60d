#!/usr/bin/env bash
# Everything from a bare Debian 12 to the first result: installs packages, builds the release preset, runs `nadir demo`.
# Arguments go to `nadir demo` (for example --seed 3 --out FOLDER); its folder appears where you stand.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

bash "$root/app/install_packages.sh" "$root/app/packages.txt"
(
  cd "$root"
  [ -f build/release/build.ninja ] || cmake --preset release >/dev/null
  cmake --build --preset release
)
exec "$root/build/release/bin/nadir" demo "$@"
