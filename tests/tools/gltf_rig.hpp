// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace arcspan::test {

using Floats = std::vector<float>;

/// Makes .glb files with skins and clips.
class GltfRig {
 public:
  nlohmann::json json = nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "accessors": [], "bufferViews": [], "buffers": [{}], "animations": []})");

  /// The number of a new accessor of floats, or of bytes for joints.
  template <class Number>
  int accessor(const char* type, std::size_t components, const std::vector<Number>& values) {
    bin_.resize((bin_.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", values.size() * sizeof(Number)}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", sizeof(Number) == 1   ? 5121
                                                   : sizeof(Number) == 2 ? 5123
                                                                         : 5126},
                                 {"count", values.size() / components},
                                 {"type", type}});
    const std::size_t at = bin_.size();
    bin_.resize(at + values.size() * sizeof(Number));
    std::memcpy(bin_.data() + at, values.data(), values.size() * sizeof(Number));
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int scalars(const Floats& values) { return accessor("SCALAR", 1, values); }
  int vectors(const Floats& values) { return accessor("VEC3", 3, values); }
  int quadruples(const Floats& values) { return accessor("VEC4", 4, values); }

  /// Adds a channel to the last animation.
  void channel(int node, const char* path, const Floats& times, int output,
               const char* interpolation = "LINEAR") {
    nlohmann::json& clip = json["animations"].back();
    clip["samplers"].push_back(
        {{"input", scalars(times)}, {"output", output}, {"interpolation", interpolation}});
    clip["channels"].push_back(
        {{"sampler", clip["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }
  void clip(const char* name) {
    json["animations"].push_back(
        {{"name", name}, {"samplers", nlohmann::json::array()}, {"channels", nlohmann::json::array()}});
  }

  [[nodiscard]] std::string glb() const {
    nlohmann::json whole = json;
    whole["buffers"][0]["byteLength"] = bin_.size();
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string bin = bin_;
    bin.resize((bin.size() + 3) / 4 * 4);
    const std::string chunks =
        little(text.size()) + "JSON" + text + little(bin.size()) + std::string("BIN\0", 4) + bin;
    return "glTF" + little(2) + little(12 + chunks.size()) + chunks;
  }

 private:
  static std::string little(std::size_t value) {
    std::string out;
    for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
    return out;
  }
  std::string bin_;
};

/// The x, y, z, w of a turn about z.
inline Floats turn_z(double degrees) {
  const double half = degrees * 3.14159265358979323846 / 360;
  return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

inline Floats joined(std::initializer_list<Floats> lists) {
  Floats all;
  for (const Floats& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// A square tube along y from 0 to 2 with `rings` rings, whose weights change from a joint at 0 to one at
/// y = 1 along it.
struct Tube {
  Floats positions{};
  Floats normals{};
  Floats weights{};                    ///< four for each vertex
  std::vector<std::uint8_t> joints{};  ///< of each weight
  std::vector<std::uint16_t> indices{};
};

inline Tube make_tube(std::size_t rings) {
  Tube tube;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const float y = 2 * static_cast<float>(ring) / static_cast<float>(rings - 1);
    for (int side = 0; side < 4; ++side) {
      const float x = side == 0 || side == 3 ? .2f : -.2f;
      const float z = side < 2 ? .2f : -.2f;
      for (const float c : {x, y, z}) tube.positions.push_back(c);
      for (const float c : {x * 3.5355339f, 0.f, z * 3.5355339f}) tube.normals.push_back(c);
      const float second = std::min(std::max(y - .5f, 0.f), 1.f);
      for (const float w : {1 - second, second, 0.f, 0.f}) tube.weights.push_back(w);
      for (const int j : {0, 1, 0, 0}) tube.joints.push_back(static_cast<std::uint8_t>(j));
      if (ring == 0) continue;
      const auto at = [](std::size_t r, int s) {
        return static_cast<std::uint16_t>(4 * r + static_cast<std::size_t>(s % 4));
      };
      for (const std::uint16_t i : {at(ring - 1, side), at(ring - 1, side + 1), at(ring, side + 1),
                                    at(ring - 1, side), at(ring, side + 1), at(ring, side)})
        tube.indices.push_back(i);
    }
  }
  return tube;
}

/// The tube on node 1 and node 2. The mesh is at node 3, which is moved and scaled and must not count. Node 0
/// scales all by `scale`, and the inverse bind matrices take that back.
inline GltfRig bending_tube(std::size_t rings = 9, float scale = 1) {
  GltfRig rig;
  const Tube tube = make_tube(rings);
  const float k = 1 / scale;  // joint 1 is at y = 1 of the model, scale times its own units
  rig.json["nodes"] = nlohmann::json::parse(R"([{"name": "armature", "children": [1, 3]},
    {"name": "lower", "children": [2]}, {"name": "upper", "translation": [0, 1, 0]},
    {"mesh": 0, "skin": 0, "translation": [50, 0, 0], "scale": [3, 3, 3]}])");
  rig.json["nodes"][0]["scale"] = {scale, scale, scale};
  rig.json["nodes"][2]["translation"] = {0, k, 0};
  const int bind = rig.accessor("MAT4", 16, Floats{k, 0, 0, 0, 0, k, 0, 0, 0, 0, k, 0, 0, 0,  0, 1,
                                                   k, 0, 0, 0, 0, k, 0, 0, 0, 0, k, 0, 0, -k, 0, 1});
  rig.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", bind}}};
  rig.json["meshes"] = {{{"name", "tube"},
                         {"primitives",
                          {{{"attributes",
                             {{"POSITION", rig.vectors(tube.positions)},
                              {"NORMAL", rig.vectors(tube.normals)},
                              {"JOINTS_0", rig.accessor("VEC4", 4, tube.joints)},
                              {"WEIGHTS_0", rig.quadruples(tube.weights)}}},
                            {"indices", rig.accessor("SCALAR", 1, tube.indices)}}}}}};
  return rig;
}

}  // namespace arcspan::test
