// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_pictures.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

namespace arcspan::tools {

std::shared_ptr<const FileTexture> FilePictures::picture(const std::string& name, const Read& read) {
  const auto [at, is_new] = known_.try_emplace(name);
  if (!is_new) return at->second;
  try {
    if (const std::optional<ReferredFile> file = read()) {
      at->second = std::make_shared<FileTexture>(FileTexture{name, decode_rgba(file->bytes, file->subject)});
    } else {
      left_out_.emplace(name, "not in the model's folder");
    }
  } catch (const Failure& failure) {
    left_out_.emplace(name, failure.reason());
  }
  return at->second;
}

void FilePictures::warn(std::vector<std::string>& warnings) const {
  if (left_out_.empty()) return;
  constexpr std::size_t kMostListed = 3;
  std::vector<std::string> shown;
  for (const auto& [name, reason] : left_out_) {
    if (shown.size() == kMostListed) break;
    shown.push_back(in_quotes(name) + " (" + reason + ")");
  }
  if (left_out_.size() > kMostListed) shown.emplace_back("...");
  warnings.push_back("left out: textures (" + std::to_string(left_out_.size()) + "): " + joined(shown, ", "));
}

std::string quoted_list(const std::vector<std::string>& names) {
  constexpr std::size_t kMostListed = 8;
  std::vector<std::string> shown;
  for (const std::string& name : names) {
    if (shown.size() < kMostListed) shown.push_back(in_quotes(name));
  }
  if (names.size() > kMostListed) shown.emplace_back("...");
  return joined(shown, ", ");
}

}  // namespace arcspan::tools
