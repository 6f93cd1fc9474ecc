# SPDX-License-Identifier: MIT
# For the steps of scripts/test.

# alone TREE COMMAND...: runs it while no other step builds in that build tree.
alone() {
  mkdir -p build/test-logs
  flock "build/test-logs/$(basename "$1").lock" "${@:2}"
}

# configured PRESET [CMAKE_OPTION...]: configures, unless it is done and there are no options: a build looks for changes itself.
configured() { [ $# -eq 1 ] && [ -e "build/$1/build.ninja" ] || cmake --preset "$@"; }
export -f configured

# build_preset PRESET [CMAKE_OPTION...]: configures and builds quietly; the last of the output if it fails.
build_preset() {
  local log=build/test-logs/build-$1.log
  mkdir -p build/test-logs
  alone "$1" bash -c 'configured "$@" && cmake --build --preset "$1"' - "$@" >"$log" 2>&1 || { tail -60 "$log"; return 1; }
}

# build_release [CMAKE_OPTION...]: the release build of the test command. Larger sources than the preset has take less processor time and keep fewer
# processors busy.
build_release() {
  scripts/fetch-meshes
  build_preset release -DARCSPAN_GOLDEN_ALL=ON -DARCSPAN_LIBRARY_UNITY=ON -DARCSPAN_TOOLS_TOGETHER=ON -DARCSPAN_TESTS_TOGETHER=100 -DARCSPAN_TESTS_ONCE=ON \
    -DARCSPAN_TIMES_LITERATURE=OFF "$@"
}
