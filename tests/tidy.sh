#!/usr/bin/env bash
# clang-tidy on the sources that have not been found clean as they are, with the headers and the rules as they are; what was
# found clean is remembered in the user's cache folder, as ccache does.
#
#   bash tests/tidy.sh [FILE...]     the files named, or all of core, widgets, app and maps
#
# Sources are checked as the tidy preset unites them, several of a module at once, since headers take most of the time.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset tidy >/dev/null  # again each time, so that new sources are in the compile commands
clean=${XDG_CACHE_HOME:-$HOME/.cache}/nadir/tidy
mkdir -p "$clean"

check() {  # check FILE CLEAN
  local headers key said
  headers=$(clang++-14 -std=c++20 -I. -Ibuild/tidy/generated -isystem /usr/include/eigen3 -MM -MG "$1" | tr -d '\\\n' | cut -d: -f2)
  # shellcheck disable=SC2086  # one word a header
  key=$2/$(cat .clang-tidy $headers 2>/dev/null | sha256sum | cut -c1-32)
  [ -e "$key" ] && return
  if ! said=$(clang-tidy-14 --quiet -p build/tidy "$1" 2>&1); then
    printf '%s\n' "$said" | grep -v 'warnings generated' >&2
    return 1
  fi
  echo "$1"
  touch "$key"
}
export -f check
units=$(grep -o '"file": "[^"]*"' build/tidy/compile_commands.json | cut -d'"' -f4 | grep -Ev "^$PWD/(build/tidy/)?tests/")
if [ $# -gt 0 ]; then  # those that are among the files named, or include one of them
  named=$(realpath "$@")
  # shellcheck disable=SC2086  # one word a file
  units=$({ grep -xF "$named" <<<"$units"; grep -lF "$named" $units; } || true)
fi
sort -u <<<"$units" | xargs -P 2 -I{} bash -c 'check "$1" "$2"' _ {} "$clean" |
  { checked=$(wc -l); echo "clang-tidy: $checked files checked and clean"; }
