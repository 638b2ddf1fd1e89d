#!/usr/bin/env bash
# Sets up and builds one preset (default: release). Options after the preset go to `cmake --build`.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ $# -gt 0 ] && shift
scripts/deps.sh
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" "$@"
