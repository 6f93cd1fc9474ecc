// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/left_out.hpp>
#include <arcspan_tools/mesh/gltf/gltf_file.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <map>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The nodes of a file's scene: of all nodes, if it has none.
struct GltfNodes {
  std::vector<JsonView> json{};                 ///< parents before their children
  std::vector<RigNode> nodes{};                 ///< of each
  std::map<std::string, std::size_t> places{};  ///< of a node in these lists, by its place in the file
};

/// Reads the tree of nodes. Throws a Failure that names the place, also for a tree that is none.
[[nodiscard]] GltfNodes read_gltf_nodes(GltfFile& file, LeftOut& left_out);

}  // namespace arcspan::tools
