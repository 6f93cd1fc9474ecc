// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/gltf/accessor.hpp>
#include <arcspan_tools/mesh/gltf/affine.hpp>
#include <arcspan_tools/mesh/gltf/gltf_file.hpp>
#include <arcspan_tools/mesh/gltf/gltf_material.hpp>
#include <arcspan_tools/mesh/gltf/gltf_skin.hpp>
#include <arcspan_tools/mesh/gltf/read_gltf.hpp>
#include <arcspan_tools/support/srgb.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace arcspan::tools {
namespace {

/// The corners of a primitive and how they make triangles.
struct Primitive {
  AccessorData positions;
  std::optional<AccessorData> normals;
  std::optional<AccessorData> colours;
  std::optional<AccessorData> texture_points;
  std::vector<std::size_t> indices;
  std::vector<Affine> places;  ///< of a skin, for each vertex; otherwise empty
};

Vec3 vec3(const AccessorData& data, std::size_t i) {
  const double* v = data.element(i);
  return {v[0], v[1], v[2]};
}

Affine affine_of(const JsonView& node) {
  if (const std::optional<JsonView> matrix = node.find("matrix")) {
    const std::vector<double> m = matrix->numbers(16, 16);
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
  }
  const auto numbers = [&node](const char* key, const std::vector<double>& value) {
    const std::optional<JsonView> member = node.find(key);
    return member ? member->numbers(value.size(), value.size()) : value;
  };
  const std::vector<double> t = numbers("translation", {0, 0, 0});
  const std::vector<double> q = numbers("rotation", {0, 0, 0, 1});
  const std::vector<double> s = numbers("scale", {1, 1, 1});
  const Vec3 axis{q[0], q[1], q[2]};
  const double squared = dot(axis, axis) + q[3] * q[3];
  if (!(squared > 0)) node.at("rotation").fail("is no rotation");
  const auto rotated = [&](Vec3 v) {
    const Vec3 half = cross(axis, v) + v * q[3];
    return v + cross(axis, half) * (2 / squared);
  };
  return {
      rotated({1, 0, 0}) * s[0], rotated({0, 1, 0}) * s[1], rotated({0, 0, 1}) * s[2], {t[0], t[1], t[2]}};
}

/// The corners of the triangles of a strip (5) or a fan (6), or as they are (4).
std::vector<std::size_t> triangulated(const std::vector<std::size_t>& corners, std::int64_t mode) {
  if (mode == 4) return corners;
  std::vector<std::size_t> triangles;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool odd = i % 2 != 0;
    const std::size_t first = mode == 6 ? corners[0] : corners[odd ? i - 1 : i - 2];
    const std::size_t second = mode == 6 ? corners[i - 1] : corners[odd ? i - 2 : i - 1];
    triangles.insert(triangles.end(), {first, second, corners[i]});
  }
  return triangles;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::string& subject, const SideFiles& files)
      : file_(bytes, subject, files), count_(subject) {}

  RawModel read() {
    struct Visit {
      JsonView node;
      Affine parent;
    };
    std::vector<Visit> open;
    const std::vector<JsonView> roots = root_nodes();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, {}});
    std::vector<JsonView> nodes;
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      const auto [placed, is_new] = transforms_.try_emplace(node.place(), parent * affine_of(node));
      if (!is_new) node.fail("is a child of two nodes, or of itself");
      nodes.push_back(node);
      const std::optional<JsonView> children = node.find("children");
      for (std::size_t i = children ? children->size() : 0; i > 0; --i) {
        open.push_back({file_.element("nodes", children->element(i - 1)), placed->second});
      }
    }
    for (const JsonView& node : nodes) read_node(node, transforms_.at(node.place()));
    note_the_rest();
    left_out_.warn(model_.warnings);
    textures_.warn(model_.warnings);
    if (skinned_ > 0) {
      model_.warnings.push_back("skinned meshes (" + std::to_string(skinned_) +
                                ") are drawn in the pose of the file's nodes, without animation");
    }
    return std::move(model_);
  }

 private:
  /// The nodes of the scene; of all nodes those without a parent if the file has no scene.
  std::vector<JsonView> root_nodes() {
    const JsonView root = file_.root();
    const std::optional<JsonView> scene = root.find("scene");
    const std::optional<JsonView> scenes = root.find("scenes");
    std::vector<JsonView> nodes;
    if (scenes && scenes->size() > 0) {
      const JsonView chosen = scene ? file_.element("scenes", *scene) : scenes->element(0);
      const std::optional<JsonView> listed = chosen.find("nodes");
      for (std::size_t i = 0; listed && i < listed->size(); ++i) {
        nodes.push_back(file_.element("nodes", listed->element(i)));
      }
      left_out_.add("further scenes", scenes->size() - 1);
      return nodes;
    }
    const std::optional<JsonView> all = root.find("nodes");
    std::set<std::string> children;
    for (std::size_t i = 0; all && i < all->size(); ++i) {
      const std::optional<JsonView> own = all->element(i).find("children");
      for (std::size_t c = 0; own && c < own->size(); ++c) {
        children.insert(file_.element("nodes", own->element(c)).place());
      }
    }
    for (std::size_t i = 0; all && i < all->size(); ++i) {
      if (children.count(all->element(i).place()) == 0) nodes.push_back(all->element(i));
    }
    return nodes;
  }

  void read_node(const JsonView& node, const Affine& transform) {
    std::vector<Affine> joints;
    if (const std::optional<JsonView> skin = node.find("skin"); skin && file_.version() == 2) {
      joints = read_joints(file_, *skin, transforms_);
      ++skinned_;
    } else if (skin || node.find("skeletons")) {  // of 1.0
      left_out_.add("skins");
    }
    note_extensions(node);
    if (const std::optional<JsonView> mesh = node.find("mesh")) read_mesh(node, *mesh, transform, joints);
    const std::optional<JsonView> several = node.find("meshes");  // of 1.0
    for (std::size_t i = 0; several && i < several->size(); ++i)
      read_mesh(node, several->element(i), transform, joints);
  }

  /// Instances of meshes (EXT_mesh_gpu_instancing), and whatever else nodes and primitives may ask for.
  void note_extensions(const JsonView& json) {
    const std::optional<JsonView> extensions = json.find("extensions");
    if (!extensions) return;
    for (const std::string& name : extensions->keys()) {
      if (name != "KHR_lights_punctual") left_out_.add(name);
    }
  }

  void read_mesh(const JsonView& node, const JsonView& id, const Affine& transform,
                 const std::vector<Affine>& joints) {
    const JsonView mesh = file_.element("meshes", id);
    std::vector<std::string> names;
    // The node is last, because parts are called by their last name and nodes may share a mesh.
    for (const std::string& name : {mesh.text_or("name", ""), node.text_or("name", "")}) {
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    const JsonView primitives = mesh.at("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      read_primitive(primitives.element(i), names, transform, joints);
    }
  }

  void read_primitive(const JsonView& json, const std::vector<std::string>& names, const Affine& transform,
                      const std::vector<Affine>& joints) {
    const std::int64_t mode = json.integer_or("mode", 4, 0, 6);
    if (mode < 4) {
      left_out_.add("points and lines");
      return;
    }
    if (json.find("targets")) left_out_.add("morph targets");
    note_extensions(json);
    const GltfMaterial material = material_of(json);
    Primitive primitive = read_corners(json, mode, material.mapping.set);
    if (!joints.empty()) {
      primitive.places = blended_joints(file_, json.at("attributes"), joints, primitive.positions.count());
    }
    const std::uint32_t look = look_of(names, material.material);
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      count_.add_face(3);
      std::array<std::size_t, 3> corners{primitive.indices[i], primitive.indices[i + 1],
                                         primitive.indices[i + 2]};
      const Affine& first = primitive.places.empty() ? transform : primitive.places[corners[0]];
      if (first.mirrors()) std::swap(corners[1], corners[2]);
      add_triangle(json, primitive, corners, transform, look, material);
    }
  }

  Primitive read_corners(const JsonView& json, std::int64_t mode, std::int64_t texture_set) {
    const JsonView attributes = json.at("attributes");
    Primitive primitive{read_accessor(file_, attributes.at("POSITION"), 3, 3), {}, {}, {}, {}, {}};
    const std::size_t vertices = primitive.positions.count();
    const auto attribute = [&](const std::string& key, std::size_t least,
                               std::size_t most) -> std::optional<AccessorData> {
      const std::optional<JsonView> id = attributes.find(key);
      if (!id) return std::nullopt;
      AccessorData data = read_accessor(file_, *id, least, most);
      if (data.count() < vertices) id->fail("has fewer elements than there are positions");
      return data;
    };
    primitive.normals = attribute("NORMAL", 3, 3);
    primitive.colours = attribute("COLOR_0", 3, 4);
    primitive.texture_points = attribute("TEXCOORD_" + std::to_string(texture_set), 2, 2);
    std::vector<std::size_t> corners;
    if (const std::optional<JsonView> id = json.find("indices")) {
      for (const double index : read_accessor(file_, *id, 1, 1).values) {
        if (!(index >= 0 && index < static_cast<double>(vertices))) {
          id->fail(formatted("index out of range (%.0f; there are %zu vertices)", index, vertices));
        }
        corners.push_back(static_cast<std::size_t>(index));
      }
    } else {
      for (std::size_t i = 0; i < vertices; ++i) corners.push_back(i);
    }
    primitive.indices = triangulated(corners, mode);
    return primitive;
  }

  void add_triangle(const JsonView& json, const Primitive& primitive,
                    const std::array<std::size_t, 3>& corners, const Affine& transform, std::uint32_t look,
                    const GltfMaterial& material) {
    std::array<RawMesh::Corner, 3> triangle;
    TriangleColour colour{primitive.colours.has_value(), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      RawMesh::Corner& corner = triangle[i];
      const Affine& place = primitive.places.empty() ? transform : primitive.places[corners[i]];
      corner.position = place.point(vec3(primitive.positions, corners[i]));
      if (!finite(corner.position) || length(corner.position) > kMostCoordinate) {
        json.at("attributes").at("POSITION").fail("a coordinate is not a number up to 1e30");
      }
      if (primitive.normals) {
        const Vec3 normal = place.normal(vec3(*primitive.normals, corners[i]));
        if (finite(normal)) {
          corner.normal = normal;
        } else {
          left_out_.add(kWrongNormals);
        }
      }
      if (primitive.texture_points) {
        const double* point = primitive.texture_points->element(corners[i]);
        if (std::isfinite(point[0]) && std::isfinite(point[1])) {
          corner.texture_point = material.mapping({point[0], point[1]});
        } else {
          left_out_.add(kWrongTexturePoints);
        }
      }
      if (primitive.colours) {
        const Vec3& base = material.base;
        const Vec3 c = vec3(*primitive.colours, corners[i]);
        if (!finite(c)) left_out_.add(kWrongColours);
        colour.known = colour.known && finite(c);
        colour.corners[i] = to_srgb(Vec3{c.x * base.x, c.y * base.y, c.z * base.z});
      }
    }
    model_.mesh.triangles.push_back(triangle);
    // Without normals a surface is flat, says the specification.
    model_.mesh.smoothing.push_back(primitive.normals ? RawMesh::kSmooth : RawMesh::kFlat);
    model_.look_of.push_back(look);
    model_.colours.push_back(colour);
  }

  GltfMaterial material_of(const JsonView& primitive) {
    const std::optional<JsonView> id = primitive.find("material");
    if (!id) return phong_of({1, 1, 1}, 0, 1);
    const JsonView json = file_.element("materials", *id);
    const auto [at, is_new] = materials_.try_emplace(json.place());
    if (is_new) at->second = read_gltf_material(file_, json, textures_, left_out_);
    return at->second;
  }

  std::uint32_t look_of(const std::vector<std::string>& names, const FileMaterial& material) {
    const PartLook look{names, material};
    const auto found = std::find(model_.looks.begin(), model_.looks.end(), look);
    const auto number = static_cast<std::uint32_t>(found - model_.looks.begin());
    if (found == model_.looks.end()) model_.looks.push_back(look);
    return number;
  }

  void note_the_rest() {
    for (const char* list : {"animations", "cameras"}) {
      const std::optional<JsonView> all = file_.root().find(list);
      if (all) left_out_.add(list, all->size());
    }
    const std::optional<JsonView> extensions = file_.root().find("extensions");
    const std::optional<JsonView> lights =
        extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    const std::optional<JsonView> listed = lights ? lights->find("lights") : std::nullopt;
    if (listed) left_out_.add("lights", listed->size());
  }

  GltfFile file_;
  TriangleCount count_;
  RawModel model_;
  std::map<std::string, GltfMaterial> materials_;  ///< by place
  GltfTextures textures_;
  NodeTransforms transforms_;
  LeftOut left_out_;
  std::size_t skinned_ = 0;
};

}  // namespace

RawModel read_gltf(std::string_view bytes, const std::string& subject, const SideFiles& files) {
  return GltfReader(bytes, subject, files).read();
}

}  // namespace arcspan::tools
