// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_pictures.hpp>
#include <arcspan_tools/mesh/file/scene_looks.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace arcspan::tools {
namespace {

std::optional<Vec3> colour(const nlohmann::json& look, const char* key) {
  if (!look.contains(key)) return std::nullopt;
  const auto channel = [&](std::size_t i) { return std::clamp(look[key][i].get<double>(), 0.0, 1.0); };
  return Vec3{channel(0), channel(1), channel(2)};
}

/// Reads names, materials and textures. Textures are pictures inside of the scene's file, or files beside it.
class LookReader {
 public:
  LookReader(const nlohmann::json& pictures, const SideFiles& files) : inner_(pictures), files_(files) {}

  PartLook read(const nlohmann::json& listed) {
    PartLook look;
    for (const nlohmann::json& name : listed["names"]) look.names.push_back(name.get<std::string>());
    FileMaterial& material = look.material;
    material.name = listed["material"].get<std::string>();
    material.colour = colour(listed, "diffuse");
    material.specular = colour(listed, "specular");
    material.emission = colour(listed, "emission").value_or(Vec3{});
    material.two_sided = listed["two_sided"].get<bool>();
    material.unlit = listed["unlit"].get<bool>();
    if (listed.contains("shininess")) {
      material.shininess =
          static_cast<std::int32_t>(std::lround(std::clamp(listed["shininess"].get<double>(), 1.0, 256.0)));
    }
    const double opacity = listed.value("opacity", 1.0);
    material.opacity = opacity > 0 ? std::min(opacity, 1.0) : 1;
    if (listed.contains("texture")) material.texture = picture(listed["texture"].get<std::string>());
    // A colour beside a texture is the library's own default, or black, which would hide it.
    if (material.texture != nullptr) material.colour = Vec3{1, 1, 1};
    return look;
  }
  void warn(std::vector<std::string>& warnings) const { pictures_.warn(warnings); }

 private:
  std::shared_ptr<const FileTexture> picture(const std::string& listed) {
    const bool is_here = listed.starts_with("./") || listed.starts_with(".\\");
    std::string name = is_here ? listed.substr(2) : listed;
    const std::string last = name.substr(name.find_last_of("/\\") + 1);
    // Exporters write the path on their own machine.
    if (name.starts_with('/') || name.find(":\\") == 1) name = last;
    return pictures_.picture(name, [&]() -> std::optional<ReferredFile> {
      if (!inner_.contains(listed)) return find_file(files_, {name, last});
      const std::vector<std::uint8_t>& bytes = inner_[listed].get_binary();
      return ReferredFile{name, std::string(bytes.begin(), bytes.end())};
    });
  }

  const nlohmann::json& inner_;
  const SideFiles& files_;
  FilePictures pictures_{};
};

}  // namespace

std::vector<PartLook> scene_looks(const nlohmann::json& scene, const SideFiles& files,
                                  std::vector<std::string>& warnings) {
  LookReader reader(scene["pictures"], files);
  std::vector<PartLook> looks;
  for (const nlohmann::json& listed : scene["looks"]) looks.push_back(reader.read(listed));
  reader.warn(warnings);
  return looks;
}

}  // namespace arcspan::tools
