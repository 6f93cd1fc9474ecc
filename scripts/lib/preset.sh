# SPDX-License-Identifier: MIT
# For the steps of scripts/test.

# alone TREE COMMAND...: runs it while no other step builds in that build tree.
alone() {
  mkdir -p build/test-logs
  flock "build/test-logs/$(basename "$1").lock" "${@:2}"
}

# build_preset PRESET [CMAKE_OPTION...]: configures and builds quietly; the last of the output if it fails.
build_preset() {
  local log=build/test-logs/build-$1.log
  mkdir -p build/test-logs
  alone "$1" bash -c 'cmake --preset "$@" && cmake --build --preset "$1"' - "$@" >"$log" 2>&1 || { tail -60 "$log"; return 1; }
}
