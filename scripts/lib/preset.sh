# SPDX-License-Identifier: MIT
# For the steps of scripts/test.

# build_preset PRESET [CMAKE_OPTION...]: configures and builds quietly; the last of the output if it fails.
build_preset() {
  local log=build/test-logs/build-$1.log
  mkdir -p build/test-logs
  { cmake --preset "$1" "${@:2}" && cmake --build --preset "$1"; } >"$log" 2>&1 || { tail -60 "$log"; return 1; }
}
