// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_pictures.hpp>
#include <arcspan_tools/mesh/file/obj_looks.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

/// The words of a name.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t end = std::min(name.find(' ', begin), name.size());
    words.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Whether a path begins at the root of a machine's files or with a drive.
bool is_absolute(const std::string& path) {
  return path.starts_with('/') || path.starts_with('\\') || path.find(":\\") == 1 || path.find(":/") == 1;
}

/// Adds the textures of a material.
void add_textures(const MtlEntry& wanted, const SideFiles& files, FilePictures& pictures, LeftOut& left_out,
                  FileMaterial& material) {
  const bool is_of_texture = wanted.opacity_map == wanted.colour_map;
  if (!wanted.opacity_map.empty() && !is_of_texture) left_out.add("opacity from another picture (map_d)");
  if (wanted.colour_map.empty()) return;
  material.texture = pictures.picture(files, wanted.colour_map);
  if (material.texture == nullptr) return;
  if (material.colour == Vec3{}) material.colour = Vec3{1, 1, 1};
  if (is_of_texture) material.alpha_mode = alpha_mode_of(material.texture->picture);
}

std::vector<std::string> list(const std::set<std::string>& names) { return {names.begin(), names.end()}; }

}  // namespace

void ObjLooks::read_libraries(const std::vector<Readings>& libraries, const SideFiles& files) {
  for (std::size_t i = 0; i < libraries.size(); ++i) {
    const auto here = libraries.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(libraries.begin(), here, *here) != here) continue;
    const auto read = [&](const std::string& name) {
      const std::optional<ReferredFile> file = files(name);
      const std::string folder = name.substr(0, name.find_last_of("/\\") + 1);
      if (file) read_mtl(file->bytes, file->subject, folder, materials_);
      return file.has_value();
    };
    // The line is one name, which may have blanks, or several.
    if (std::ranges::any_of(*here, read)) continue;
    // Some programs write where the library is on their own machine.
    const auto read_beside = [&](const std::string& name) {
      return is_absolute(name) && read(name.substr(name.find_last_of("/\\") + 1));
    };
    if (std::ranges::any_of(*here, read_beside)) continue;
    for (const std::string& name : words_of(here->back())) {
      if (!read(name)) missing_.insert(name);
    }
  }
}

void ObjLooks::note(const TextLines& lines) {
  const std::string_view keyword = lines.words()[0];
  if (keyword == "o") {
    object_ = lines.name();  // selected by any reading
  } else if (keyword == "g") {
    groups_ = words_of(lines.name()[0]);
  } else if (keyword == "usemtl") {
    material_ = lines.name();
  } else {
    return;
  }
  changed_ = true;
}

std::string ObjLooks::material_name() {
  if (const MtlEntry* known = materials_.find(material_)) return known->look.name;
  if (!material_.back().empty()) undefined_.insert(material_.back());
  return material_.back();
}

std::uint32_t ObjLooks::current() {
  if (!changed_) return current_;
  changed_ = false;
  Key key{{}, material_name()};
  for (const std::vector<std::string>* names : {&object_, &groups_}) {
    for (const std::string& name : *names) {
      const bool is_new = std::find(key.first.begin(), key.first.end(), name) == key.first.end();
      if (!name.empty() && is_new) key.first.push_back(name);
    }
  }
  current_ = numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(numbers_.size())).first->second;
  return current_;
}

std::vector<PartLook> ObjLooks::finish(const SideFiles& files, std::vector<std::string>& warnings) {
  FilePictures pictures;
  std::vector<PartLook> looks(numbers_.size());
  for (const auto& [key, number] : numbers_) {
    looks[number] = {key.first, FileMaterial{key.second}};
    const auto known = materials_.by_name.find(key.second);
    if (known == materials_.by_name.end()) continue;
    looks[number].material = known->second.look;
    add_textures(known->second, files, pictures, materials_.left_out, looks[number].material);
  }
  if (!missing_.empty()) {
    warnings.push_back("cannot read " + quoted_list(list(missing_)) +
                       " (mtllib) from the model's folder; materials are drawn in the default look");
  } else if (!undefined_.empty()) {
    warnings.push_back("materials that are not defined (" + std::to_string(undefined_.size()) +
                       ") are drawn in the default look: " + quoted_list(list(undefined_)));
  }
  warn_of(materials_, warnings);
  pictures.warn(warnings);
  return looks;
}

}  // namespace arcspan::tools
