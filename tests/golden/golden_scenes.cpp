// SPDX-License-Identifier: MIT
#include <tests/golden/golden_scenes.hpp>

namespace arcspan::test {
namespace {

tools::Scene base() {
  tools::Scene scene;
  scene.size = {96, 72};
  return scene;
}

GoldenScene phong() {
  GoldenScene golden{"arc-phong", "arc", base()};
  golden.scene.highlight = Highlight::kPhong;
  return golden;
}

GoldenScene exact() {
  GoldenScene golden{"arc-0", "arc", base(), true};
  golden.scene.tolerance = 0;
  return golden;
}

// Four lights, and a camera so near that parts lie behind it and beside the guard band.
GoldenScene near_with_four_lights() {
  GoldenScene golden{"arc-near", "arc", base()};
  golden.scene.lights = {{0.4, 0.7, 0.6}, {-1, 0, 0.2}, {0, -1, 0.5}, {0.3, 0.2, 1}};
  golden.scene.surface.diffuse = 0.4;
  golden.scene.camera.fov_degrees = 100;
  golden.scene.two_sided = true;
  return golden;
}

GoldenScene painters_order() {
  GoldenScene golden{"gouraud-no-depth", "gouraud", base()};
  golden.scene.depth = false;
  golden.scene.two_sided = true;
  return golden;
}

}  // namespace

std::vector<GoldenScene> golden_scenes() {
  std::vector<GoldenScene> scenes;
  for (const std::string& shading : tools::shading_names()) {
    // Formats and meshes are what these three vary; the others differ from them in colours only.
    const bool whole = shading == "flat" || shading == "gouraud" || shading == "arc";
    scenes.push_back({shading, shading, base(), !whole});
  }
  scenes.push_back(exact());
  scenes.push_back(phong());
  scenes.push_back(near_with_four_lights());
  scenes.push_back(painters_order());
  return scenes;
}

}  // namespace arcspan::test
