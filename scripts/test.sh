#!/usr/bin/env bash
# Sets up, builds and runs every test. Options go to ctest (for example: scripts/test.sh -R solve).
#   PRESET=asan scripts/test.sh     the same under a sanitizer (release, debug, asan, tsan)
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${PRESET:-release}
scripts/build.sh "$preset" >&2
ctest --preset "$preset" -j2 "$@"
