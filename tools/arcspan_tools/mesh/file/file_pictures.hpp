// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The pictures that a model file refers to, each read once. Those that cannot be read are left out.
class FilePictures {
 public:
  using Read = std::function<std::optional<ReferredFile>()>;

  /// The picture in the file that `read` returns at the first call with this `name`; null if it is missing or
  /// cannot be decoded.
  std::shared_ptr<const FileTexture> picture(const std::string& name, const Read& read);
  std::shared_ptr<const FileTexture> picture(const SideFiles& files, const Readings& names) {
    return picture(names[0], [&] { return find_file(files, names); });
  }

  /// Adds a line that names those that were left out and says why.
  void warn(std::vector<std::string>& warnings) const;

 private:
  std::map<std::string, std::shared_ptr<const FileTexture>> known_{};
  std::map<std::string, std::string> left_out_{};  ///< with the reason
};

/// The names in quotes, separated by commas; of many the first ones and dots.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& names);

}  // namespace arcspan::tools
