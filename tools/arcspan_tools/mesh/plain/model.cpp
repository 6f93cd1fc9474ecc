// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace arcspan::tools {

std::size_t Model::vertex_count() const {
  std::size_t count = 0;
  for (const ModelPart& part : parts) count += part.mesh.positions.size();
  return count;
}

std::size_t Model::triangle_count() const {
  std::size_t count = 0;
  for (const ModelPart& part : parts) count += part.mesh.triangles.size();
  return count;
}

AlphaMode alpha_mode_of(const RgbaImage& picture) {
  AlphaMode mode = AlphaMode::kOpaque;
  for (const Rgba8 c : picture.pixels) {
    if (c.a == 255) continue;
    if (c.a > 0) return AlphaMode::kBlend;
    mode = AlphaMode::kMask;
  }
  return mode;
}

Model to_model(MeshData mesh) {
  Model model;
  model.dropped_faces = std::exchange(mesh.dropped_faces, 0);
  model.parts.push_back({{}, std::move(mesh)});
  return model;
}

RawModel to_raw(const Model& model) {
  RawModel raw;
  for (const ModelPart& part : model.parts) {
    const MeshData& mesh = part.mesh;
    for (const auto& t : mesh.triangles) {
      const auto corner = [&mesh](std::uint32_t i) {
        RawMesh::Corner c{mesh.positions[i], mesh.normals[i]};
        if (!mesh.texture_points.empty()) c.texture_point = mesh.texture_points[i];
        if (!mesh.colours.empty()) c.colour = mesh.colours[i];
        return c;
      };
      raw.mesh.triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
      raw.look_of.push_back(static_cast<std::uint32_t>(raw.looks.size()));
    }
    raw.looks.push_back(part.look);
  }
  raw.warnings = model.warnings;
  return raw;
}

Model select_parts(Model model, const std::string& name, const std::string& subject) {
  std::set<std::string> names;
  std::vector<ModelPart> selected;
  for (ModelPart& part : model.parts) {
    const std::vector<std::string>& own = part.look.names;
    names.insert(own.begin(), own.end());
    if (std::find(own.begin(), own.end(), name) != own.end()) selected.push_back(std::move(part));
  }
  if (selected.empty()) {
    constexpr std::size_t kMostListed = 20;
    std::string list;
    std::size_t listed = 0;
    for (const std::string& known : names) {
      if (listed++ == kMostListed) break;
      list += (list.empty() ? "" : ", ") + known;
    }
    if (names.size() > kMostListed) list += ", ...";
    throw Failure(subject, "no group '" + name + "'" +
                               (names.empty() ? " (it has no names)" : " (there are: " + list + ")"));
  }
  model.parts = std::move(selected);
  return model;
}

}  // namespace arcspan::tools
