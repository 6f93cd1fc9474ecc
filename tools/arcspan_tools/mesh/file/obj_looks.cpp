// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/obj_looks.hpp>
#include <arcspan_tools/mesh/file/read_mtl.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <set>

namespace arcspan::tools {
namespace {

/// Names of a list in a warning; the others are dots.
constexpr std::size_t kMostListed = 8;

void read_library(const std::string& line, const SideFiles& files, MtlMaterials& materials,
                  std::set<std::string>& missing) {
  // The line is one name, which may have blanks, or several.
  if (const std::optional<ReferredFile> file = files(line))
    return read_mtl(file->bytes, file->subject, materials);
  for (std::size_t begin = 0; begin < line.size();) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    const std::string name = line.substr(begin, end - begin);
    if (const std::optional<ReferredFile> file = files(name)) {
      read_mtl(file->bytes, file->subject, materials);
    } else {
      missing.insert(name);
    }
    begin = end + 1;
  }
}

std::string quoted_list(const std::set<std::string>& names) {
  std::vector<std::string> shown;
  for (const std::string& name : names) {
    if (shown.size() == kMostListed) {
      shown.emplace_back("...");
      break;
    }
    shown.push_back(in_quotes(name));
  }
  return joined(shown, ", ");
}

/// Reads the pictures of materials, each once.
class ObjTextures {
 public:
  ObjTextures(const SideFiles& files, const MtlMaterials& materials) : files_(files), materials_(materials) {}

  /// Adds the texture of a material, if it has one.
  void add_to(FileMaterial& material) {
    const auto wanted = materials_.textures.find(material.name);
    if (wanted == materials_.textures.end() || wanted->second.colour.empty()) return;
    material.texture = picture(wanted->second.colour);
    if (material.texture == nullptr) return;
    if (material.colour == Vec3{}) material.colour = Vec3{1, 1, 1};
    const std::string& opacity = wanted->second.opacity;
    if (opacity == wanted->second.colour) material.alpha_mode = alpha_mode_of(material.texture->picture);
    if (!opacity.empty() && opacity != wanted->second.colour) other_opacity_ = true;
  }

  void warn_of(std::vector<std::string>& warnings) const {
    if (!missing_.empty()) {
      warnings.push_back("cannot read the textures " + quoted_list(missing_) +
                         " from the model's folder; the parts are drawn without them");
    }
    if (other_opacity_) warnings.emplace_back("opacity from another picture (map_d) is not drawn");
  }

 private:
  std::shared_ptr<const FileTexture> picture(const std::string& name) {
    const auto [at, is_new] = known_.try_emplace(name);
    if (!is_new) return at->second;
    if (const std::optional<ReferredFile> file = files_(name)) {
      at->second = std::make_shared<FileTexture>(FileTexture{name, decode_rgba(file->bytes, file->subject)});
    } else {
      missing_.insert(name);
    }
    return at->second;
  }

  const SideFiles& files_;
  const MtlMaterials& materials_;
  std::map<std::string, std::shared_ptr<const FileTexture>> known_;
  std::set<std::string> missing_;
  bool other_opacity_ = false;
};

}  // namespace

void ObjLooks::note(const TextLines& lines) {
  const std::string_view keyword = lines.words()[0];
  if (keyword == "o") {
    object_ = rest_of_line(lines);
  } else if (keyword == "g") {
    groups_.assign(lines.words().begin() + 1, lines.words().end());
  } else if (keyword == "usemtl") {
    material_ = rest_of_line(lines);
  } else if (keyword == "mtllib") {
    const std::string name = rest_of_line(lines);
    if (!name.empty() && std::find(libraries_.begin(), libraries_.end(), name) == libraries_.end()) {
      libraries_.push_back(name);
    }
    return;
  } else {
    return;
  }
  changed_ = true;
}

std::uint32_t ObjLooks::current() {
  if (!changed_) return current_;
  changed_ = false;
  Key key{{}, material_};
  if (!object_.empty()) key.first.push_back(object_);
  for (const std::string& group : groups_) {
    if (group != object_) key.first.push_back(group);
  }
  current_ = numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(numbers_.size())).first->second;
  return current_;
}

std::vector<PartLook> ObjLooks::finish(const SideFiles& files, std::vector<std::string>& warnings) {
  MtlMaterials materials;
  std::set<std::string> missing;
  for (const std::string& library : libraries_) read_library(library, files, materials, missing);
  ObjTextures textures(files, materials);
  std::set<std::string> undefined;
  std::vector<PartLook> looks(numbers_.size());
  for (const auto& [key, number] : numbers_) {
    looks[number].names = key.first;
    if (key.second.empty()) continue;
    const auto known = materials.by_name.find(key.second);
    looks[number].material = known == materials.by_name.end() ? FileMaterial{key.second} : known->second;
    if (known == materials.by_name.end()) undefined.insert(key.second);
    textures.add_to(looks[number].material);
  }
  if (!undefined.empty() && !missing.empty()) {
    warnings.push_back("cannot read " + quoted_list(missing) +
                       " (mtllib) from the model's folder; materials are drawn in the default look");
  } else if (!undefined.empty()) {
    warnings.push_back("materials that are not defined are drawn in the default look: " +
                       quoted_list(undefined));
  }
  for (std::string& warning : warnings_of(materials)) warnings.push_back(std::move(warning));
  textures.warn_of(warnings);
  return looks;
}

}  // namespace arcspan::tools
