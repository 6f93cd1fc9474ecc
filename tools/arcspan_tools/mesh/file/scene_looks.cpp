// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/scene_looks.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace arcspan::tools {
namespace {

std::optional<Vec3> colour(const nlohmann::json& look, const char* key) {
  if (!look.contains(key)) return std::nullopt;
  const auto channel = [&](std::size_t i) { return std::clamp(look[key][i].get<double>(), 0.0, 1.0); };
  return Vec3{channel(0), channel(1), channel(2)};
}

/// Reads the pictures of a scene, each once.
class SceneTextures {
 public:
  SceneTextures(const SideFiles& files, std::vector<std::string>& warnings)
      : files_(files), warnings_(warnings) {}

  std::shared_ptr<const FileTexture> picture(std::string name) {
    if (name.starts_with("./") || name.starts_with(".\\")) name.erase(0, 2);
    const auto [at, is_new] = known_.try_emplace(name);
    if (!is_new) return at->second;
    if (const std::optional<ReferredFile> file = files_(name)) {
      at->second = std::make_shared<FileTexture>(FileTexture{name, decode_rgba(file->bytes, file->subject)});
    } else {
      warnings_.push_back("cannot read the texture " + in_quotes(name) +
                          " from the model's folder; its parts are drawn without it");
    }
    return at->second;
  }

 private:
  const SideFiles& files_;
  std::vector<std::string>& warnings_;
  std::map<std::string, std::shared_ptr<const FileTexture>> known_;
};

PartLook look_of(const nlohmann::json& listed, SceneTextures& textures) {
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
  if (listed.contains("texture")) material.texture = textures.picture(listed["texture"].get<std::string>());
  // A colour beside a texture is the library's own default, or black, which would hide it.
  if (material.texture != nullptr) material.colour = Vec3{1, 1, 1};
  return look;
}

}  // namespace

RawModel scene_model(ImportedMesh mesh, const std::string& subject, const SideFiles& files) {
  RawModel model;
  SceneTextures textures(files, model.warnings);
  for (const nlohmann::json& listed : nlohmann::json::parse(mesh.looks))
    model.looks.push_back(look_of(listed, textures));
  model.mesh.triangles = std::move(mesh.triangles);
  for (const TriangleSource& source : mesh.sources) {
    if (source.face >= model.looks.size()) throw Failure(subject, "the loader made up a material");
    model.look_of.push_back(source.face);
  }
  if (model.look_of.size() != model.mesh.triangles.size()) throw Failure(subject, "no faces");
  return model;
}

}  // namespace arcspan::tools
