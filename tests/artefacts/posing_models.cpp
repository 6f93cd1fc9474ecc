// SPDX-License-Identifier: MIT
// posing_models OUTPUT: writes tubes of 19 joints, with 1, 2, 3 and 4 weights for each vertex, and tubes
// whose vertices 1 and 4 morph targets move, as records for tests/firmware/cost_pose.cpp.
#include <tests/support/animated_rig.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace {

/// Adds near joints to the vertices that have fewer, such as those in the middle of a joint.
void give_weights(arcspan::test::Rig& rig, std::size_t weights) {
  for (arcspan::test::RigVertex& vertex : rig.vertices) {
    std::vector<arcspan::test::RigWeight>& some = vertex.weights;
    const int first = some.front().joint;
    for (int joint = first < 9 ? first + 1 : first - 4; some.size() < weights; ++joint) {
      const auto is_joint = [joint](const arcspan::test::RigWeight& w) { return w.joint == joint; };
      if (std::none_of(some.begin(), some.end(), is_joint)) some.push_back({joint, 64});
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ofstream out(arguments[1], std::ios::binary);
  const auto put = [&out](std::uint32_t word) {
    for (int i = 0; i < 4; ++i) out.put(static_cast<char>(word >> (8 * i) & 0xFF));
  };
  const auto put_model = [&](std::string name, const arcspan::test::Rig& rig) {
    const auto file = rig.file();
    name.resize(24);
    out << name;
    put(static_cast<std::uint32_t>(file.size()));
    for (int i = 0; i < 8; ++i) put(0);  // without a picture
    out.write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    for (std::size_t i = file.size(); i % 4 != 0; ++i) out.put('\0');
  };
  for (int weights = 1; weights <= 4; ++weights) {
    arcspan::test::Rig rig = arcspan::test::tube(19, weights, 30000, 3000, 1);
    give_weights(rig, static_cast<std::size_t>(weights));
    rig.clips.push_back(bending(rig, arcspan::Interpolation::kLinear, 20));
    put_model(std::to_string(weights), rig);
  }
  for (const int targets : {1, 4}) {
    arcspan::test::Rig rig = arcspan::test::tube(19, 1, 30000, 3000, 1);
    rig.targets = targets;
    for (arcspan::test::RigVertex& vertex : rig.vertices) {
      for (int i = 0; i < targets; ++i) vertex.morphs.push_back({i, {100, 200, 300}, {0.1, 0.2, 0.3}});
    }
    put_model("morph " + std::to_string(targets), rig);
  }
  for (int i = 0; i < 64; ++i) out.put('\0');
  return out.flush() ? 0 : 1;
}
