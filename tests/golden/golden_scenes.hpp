// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/scene.hpp>

#include <string>
#include <vector>

namespace arcspan::test {

/// A picture of a mesh whose pixels are pinned, in every pixel format and band height.
struct GoldenScene {
  std::string name;  ///< "arc", "arc-phong", ...: a file name
  std::string shading;
  tools::Scene scene;
  bool sample = false;  ///< in rgb888 and of two generated meshes only
};

/// The scenes that every mesh is drawn in. A new shading method is added automatically, as a sample.
[[nodiscard]] std::vector<GoldenScene> golden_scenes();

}  // namespace arcspan::test
