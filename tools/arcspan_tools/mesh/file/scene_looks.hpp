// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace arcspan::tools {

/// The looks that a scene of import_scene() lists, with their pictures. Of those that are missing it warns.
[[nodiscard]] std::vector<PartLook> scene_looks(const nlohmann::json& scene, const SideFiles& files,
                                                std::vector<std::string>& warnings);

}  // namespace arcspan::tools
