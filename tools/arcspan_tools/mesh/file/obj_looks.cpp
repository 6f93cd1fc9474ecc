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
  std::set<std::string> undefined;
  std::vector<PartLook> looks(numbers_.size());
  for (const auto& [key, number] : numbers_) {
    looks[number].names = key.first;
    if (key.second.empty()) continue;
    const auto known = materials.by_name.find(key.second);
    looks[number].material = known == materials.by_name.end() ? FileMaterial{key.second} : known->second;
    if (known == materials.by_name.end()) undefined.insert(key.second);
  }
  if (!undefined.empty() && !missing.empty()) {
    warnings.push_back("cannot read " + quoted_list(missing) +
                       " (mtllib) from the model's folder; materials are drawn in the default look");
  } else if (!undefined.empty()) {
    warnings.push_back("materials that are not defined are drawn in the default look: " +
                       quoted_list(undefined));
  }
  for (std::string& warning : warnings_of(materials)) warnings.push_back(std::move(warning));
  return looks;
}

}  // namespace arcspan::tools
