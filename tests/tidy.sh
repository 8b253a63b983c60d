#!/usr/bin/env bash
# clang-tidy on the sources that differ from what the last clean run saw; on all of them the first time.
#
#   bash tests/tidy.sh [FILE...]
set -euo pipefail
cd "$(dirname "$0")/.."

[ -f build/tidy/build.ninja ] || cmake --preset tidy -DCMAKE_CXX_CLANG_TIDY= >/dev/null
stamps=build/tidy/clean
mkdir -p "$stamps"
# A file is clean as long as it, every header of ours and the rules are what they were.
rules=$(cat .clang-tidy $(git ls-files '*.h') | sha256sum | cut -c1-16)
dirty=()
if [ $# -gt 0 ]; then
  dirty=("$@")
else
  for file in $(git ls-files 'core/*.cpp' 'app/*.cpp' 'maps/*.cpp'); do
    stamp=$stamps/$(printf '%s %s' "$rules" "$(sha256sum "$file")" | sha256sum | cut -c1-32)
    [ -e "$stamp" ] || dirty+=("$file")
  done
fi
[ ${#dirty[@]} -eq 0 ] && { echo 'clang-tidy: nothing has changed'; exit 0; }
echo "clang-tidy: ${#dirty[@]} files"
check() {
  clang-tidy-14 --quiet -p build/tidy "$1" 2>/dev/null || return 1
  touch "$2/$(printf '%s %s' "$3" "$(sha256sum "$1")" | sha256sum | cut -c1-32)"
}
export -f check
printf '%s\0' "${dirty[@]}" | xargs -0 -P 2 -I{} bash -c 'check "$1" "$2" "$3"' _ {} "$stamps" "$rules"
