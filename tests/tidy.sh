#!/usr/bin/env bash
# clang-tidy on the sources that have changed since they were last found clean; on all of them the first time.
#
#   bash tests/tidy.sh [FILE...]
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset tidy >/dev/null  # again each time, so that new sources are in the compile commands
stamps=build/tidy/clean
mkdir -p "$stamps"
# A file is clean as long as it, every header of ours and the rules are what they were.
rules=$(find core app maps -name '*.h' -print0 | sort -z | xargs -0 cat .clang-tidy | sha256sum | cut -c1-16)
dirty=()
if [ $# -gt 0 ]; then
  dirty=("$@")
else
  while IFS= read -r file; do
    stamp=$stamps/$(printf '%s %s' "$rules" "$(sha256sum "$file")" | sha256sum | cut -c1-32)
    [ -e "$stamp" ] || dirty+=("$file")
  done < <(find core app maps -name '*.cpp' | sort)
fi
[ ${#dirty[@]} -eq 0 ] && { echo 'clang-tidy: nothing has changed'; exit 0; }
echo "clang-tidy: ${#dirty[@]} files"
check() {
  local said
  if ! said=$(clang-tidy-14 --quiet -p build/tidy "$1" 2>&1); then
    printf '%s\n' "$said" | grep -v 'warnings generated' >&2
    return 1
  fi
  touch "$2/$(printf '%s %s' "$3" "$(sha256sum "$1")" | sha256sum | cut -c1-32)"
}
export -f check
printf '%s\0' "${dirty[@]}" | xargs -0 -P 2 -I{} bash -c 'check "$1" "$2" "$3"' _ {} "$stamps" "$rules"
