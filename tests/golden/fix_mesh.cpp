// SPDX-License-Identifier: MIT
// fix_mesh MESH OUT.fixed: what `arcspan render` makes of a mesh, as a file for golden_tests.
#include <arcspan_tools/mesh/file/load.hpp>
#include <tests/golden/fixed_file.hpp>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: fix_mesh MESH OUT.fixed\n");
    return 2;
  }
  try {
    arcspan::test::write_fixed(
        arcspan::tools::to_fixed(arcspan::tools::load_mesh(argv[1], arcspan::tools::kSmoothEverything)),
        argv[2]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fix_mesh: %s\n", e.what());
    return 1;
  }
  return 0;
}
