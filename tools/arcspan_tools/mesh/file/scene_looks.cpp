// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_pictures.hpp>
#include <arcspan_tools/mesh/file/left_out.hpp>
#include <arcspan_tools/mesh/file/scene_looks.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace arcspan::tools {
namespace {

std::optional<Vec3> colour(const nlohmann::json& look, const char* key) {
  if (!look.contains(key)) return std::nullopt;
  const auto channel = [&](std::size_t i) { return std::clamp(look[key][i].get<double>(), 0.0, 1.0); };
  return Vec3{channel(0), channel(1), channel(2)};
}

PartLook look_of(const nlohmann::json& listed, const SideFiles& files, FilePictures& pictures) {
  PartLook look;
  for (const nlohmann::json& name : listed["names"]) look.names.push_back(name.get<std::string>());
  FileMaterial& material = look.material;
  material.name = listed["material"].get<std::string>();
  material.colour = colour(listed, "diffuse");
  material.specular = colour(listed, "specular");
  material.emission = colour(listed, "emission").value_or(Vec3{});
  material.two_sided = listed["two_sided"].get<bool>();
  if (listed.contains("shininess")) {
    material.shininess =
        static_cast<std::int32_t>(std::lround(std::clamp(listed["shininess"].get<double>(), 1.0, 256.0)));
  }
  if (listed.contains("texture")) {
    auto name = listed["texture"].get<std::string>();
    if (name.starts_with("./") || name.starts_with(".\\")) name.erase(0, 2);
    material.texture = pictures.picture(files, {name});
  }
  // A colour beside a texture is the library's own default, or black, which would hide it.
  if (material.texture != nullptr) material.colour = Vec3{1, 1, 1};
  return look;
}

template <class T>
void take(const nlohmann::json& binary, std::vector<T>& values) {
  const std::vector<std::uint8_t>& bytes = binary.get_binary();
  values.resize(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(T));
}

}  // namespace

RawModel scene_model(const std::string& imported, const std::string& subject, const SideFiles& files) {
  const nlohmann::json scene = nlohmann::json::from_cbor(imported, true, false);
  if (scene.is_discarded()) throw Failure(subject, "the mesh loader was interrupted");
  RawModel model;
  FilePictures pictures;
  for (const nlohmann::json& listed : scene["looks"]) {
    model.looks.push_back(look_of(listed, files, pictures));
  }
  pictures.warn(model.warnings);
  LeftOut left_out;
  for (const auto& [kind, count] : scene["left_out"].items()) left_out.add(kind, count.get<std::size_t>());
  std::vector<std::string> motion;
  left_out.warn(motion);
  for (const std::string& line : motion)
    model.warnings.push_back(line + "; what moves is read from .gltf and .glb, as which programs export it");
  take(scene["triangles"], model.mesh.triangles);
  take(scene["look_of"], model.look_of);
  if (model.mesh.triangles.empty()) throw Failure(subject, "no faces");
  return model;
}

}  // namespace arcspan::tools
