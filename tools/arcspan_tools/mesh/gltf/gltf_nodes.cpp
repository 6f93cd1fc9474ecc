// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_nodes.hpp>

#include <optional>
#include <set>

namespace arcspan::tools {
namespace {

RigNode read_node(const JsonView& json) {
  RigNode node;
  node.name = json.text_or("name", "");
  if (const std::optional<JsonView> matrix = json.find("matrix")) {
    node.matrix = affine_of(matrix->numbers(16, 16).data());
    return node;
  }
  const auto numbers = [&json](const char* key, const std::vector<double>& value) {
    const std::optional<JsonView> member = json.find(key);
    return member ? member->numbers(value.size(), value.size()) : value;
  };
  const std::vector<double> t = numbers("translation", {0, 0, 0});
  const std::vector<double> q = numbers("rotation", {0, 0, 0, 1});
  const std::vector<double> s = numbers("scale", {1, 1, 1});
  node.rest = {{t[0], t[1], t[2]}, {q[0], q[1], q[2], q[3]}, {s[0], s[1], s[2]}};
  if (!(inner(node.rest.rotation, node.rest.rotation) > 0)) json.at("rotation").fail("is no rotation");
  return node;
}

/// Of all nodes those without a parent.
std::vector<JsonView> nodes_without_parent(GltfFile& file) {
  const std::optional<JsonView> all = file.root().find("nodes");
  std::set<std::string> children;
  for (std::size_t i = 0; all && i < all->size(); ++i) {
    const std::optional<JsonView> own = all->element(i).find("children");
    for (std::size_t c = 0; own && c < own->size(); ++c)
      children.insert(file.element("nodes", own->element(c)).place());
  }
  std::vector<JsonView> roots;
  for (std::size_t i = 0; all && i < all->size(); ++i) {
    if (children.count(all->element(i).place()) == 0) roots.push_back(all->element(i));
  }
  if (all && all->size() > 0 && roots.empty()) all->element(0).fail("is a child of itself");
  return roots;
}

/// The nodes of the scene; of all nodes those without a parent if the file has no scene.
std::vector<JsonView> root_nodes(GltfFile& file, LeftOut& left_out) {
  const JsonView root = file.root();
  const std::optional<JsonView> scene = root.find("scene");
  const std::optional<JsonView> scenes = root.find("scenes");
  if (!scenes || scenes->size() == 0) return nodes_without_parent(file);
  const JsonView chosen = scene ? file.element("scenes", *scene) : scenes->element(0);
  const std::optional<JsonView> listed = chosen.find("nodes");
  std::vector<JsonView> roots;
  for (std::size_t i = 0; listed && i < listed->size(); ++i)
    roots.push_back(file.element("nodes", listed->element(i)));
  left_out.add("further scenes", scenes->size() - 1);
  return roots;
}

}  // namespace

GltfNodes read_gltf_nodes(GltfFile& file, LeftOut& left_out) {
  struct Visit {
    JsonView json;
    std::optional<std::size_t> parent;
  };
  std::vector<Visit> open;
  const std::vector<JsonView> roots = root_nodes(file, left_out);
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, {}});
  GltfNodes all;
  while (!open.empty()) {
    const auto [json, parent] = open.back();
    open.pop_back();
    const std::size_t number = all.nodes.size();
    RigNode node = read_node(json);
    if (!all.places.try_emplace(json.place(), number).second)
      json.fail("is a child of two nodes, or of itself");
    node.parent = parent;
    all.json.push_back(json);
    all.nodes.push_back(node);
    const std::optional<JsonView> children = json.find("children");
    for (std::size_t i = children ? children->size() : 0; i > 0; --i)
      open.push_back({file.element("nodes", children->element(i - 1)), number});
  }
  return all;
}

}  // namespace arcspan::tools
