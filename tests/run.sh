#!/usr/bin/env bash
# Installs what is missing, builds the dev preset and runs its tests. The recorded data are found in NADIR_TEST_DATA, or in
# ../shared/data where that is there; without them the tests that need them are skipped.
#
#   bash tests/run.sh            format, dev build, all tests
#   bash tests/run.sh --all      the same, then AddressSanitizer + UBSan, ThreadSanitizer, fuzzers and clang-tidy (CI)
set -euo pipefail
cd "$(dirname "$0")/.."

bash app/install_packages.sh app/packages.txt tests/packages.txt
if [ -z "${NADIR_TEST_DATA:-}" ] && [ -d ../shared/data ]; then
  NADIR_TEST_DATA=$(cd ../shared/data && pwd)
  export NADIR_TEST_DATA
fi

step() { printf '\n== %s (%d s)\n' "$1" "$SECONDS"; }

build() {  # build PRESET [TARGET...]
  local preset=$1
  shift
  [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" ${@:+--target "$@"}
}

step 'format'
git ls-files -z '*.h' '*.cpp' | xargs -0 clang-format-14 --dry-run -Werror
if [ "${1:-}" = --all ]; then
  step 'AddressSanitizer and UndefinedBehaviorSanitizer'
  build asan
  ctest --preset asan
  step 'ThreadSanitizer'
  build tsan thread_tests
  ctest --preset tsan
  step 'fuzzers'
  build fuzz fuzzers
  ctest --preset fuzz
  step 'clang-tidy'
  bash tests/tidy.sh
fi
step 'dev build and tests'
build dev
ctest --preset dev
step 'done'
