#!/usr/bin/env bash
# Installs what is missing, builds the dev preset and runs its tests. The recorded data are found in NADIR_TEST_DATA, or in
# ../shared/data where that is there; without them the tests that need them are skipped.
#
#   bash tests/run.sh            format, dev build, all tests
#   bash tests/run.sh --all      what CI runs: the tests of the whole program in an optimised build, unit tests and fuzzers
#                                with AddressSanitizer + UBSan, those of threads with ThreadSanitizer, clang-tidy
set -euo pipefail
cd "$(dirname "$0")/.."

bash app/install_packages.sh app/packages.txt tests/packages.txt
if [ -z "${NADIR_TEST_DATA:-}" ] && [ -d ../shared/data ]; then
  NADIR_TEST_DATA=$(cd ../shared/data && pwd)
  export NADIR_TEST_DATA
fi

step() { printf '\n== %s (%d s)\n' "$1" "$SECONDS"; }

check() {  # check PRESET: build and test
  [ -f "build/$1/build.ninja" ] || cmake --preset "$1" >/dev/null
  cmake --build --preset "$1"
  ctest --preset "$1"
}

step 'format'
find core widgets app maps tests -name '*.h' -print0 -o -name '*.cpp' -print0 | xargs -0 clang-format-14 --dry-run -Werror
if [ "${1:-}" != --all ]; then
  step 'dev build and tests'
  check dev
else
  step 'build and tests'
  check ci
  step 'clang-tidy'
  bash tests/tidy.sh
  step 'ThreadSanitizer'
  check tsan
  step 'AddressSanitizer, UndefinedBehaviorSanitizer, fuzzers'
  check asan
fi
step 'done'
