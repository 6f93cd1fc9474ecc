// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/gltf/accessor.hpp>
#include <arcspan_tools/mesh/gltf/gltf_clips.hpp>
#include <arcspan_tools/mesh/gltf/gltf_file.hpp>
#include <arcspan_tools/mesh/gltf/gltf_material.hpp>
#include <arcspan_tools/mesh/gltf/gltf_nodes.hpp>
#include <arcspan_tools/mesh/gltf/gltf_skin.hpp>
#include <arcspan_tools/mesh/gltf/gltf_vertices.hpp>
#include <arcspan_tools/mesh/gltf/read_gltf.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/mesh/plain/rig_vertices.hpp>
#include <arcspan_tools/support/srgb.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
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
};

/// How a corner of a primitive gets to its place.
struct CornerPlace {
  Affine transform;
  Vec3 position;  ///< with its morph targets
  Vec3 normal;
  std::uint32_t source = kNoSource;
};

/// The skin that the vertices of a part follow, and the instance of a mesh whose morph targets they have.
struct MovedBy {
  std::optional<std::size_t> morphing_instance{};  ///< with morph targets
  std::optional<std::size_t> skin{};

  friend bool operator==(const MovedBy&, const MovedBy&) = default;
};

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

/// Vertices with an opacity below 1.
std::size_t transparent_vertices(const std::optional<AccessorData>& colours) {
  if (!colours || colours->components < 4) return 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < colours->count(); ++i) count += colours->element(i)[3] < 1;
  return count;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::string& subject, const SideFiles& files)
      : file_(bytes, subject, files), count_(subject) {}

  RawModel read() {
    nodes_ = read_gltf_nodes(file_, left_out_);
    if (file_.version() == 2) {
      const auto targets = [this](std::size_t node) { return morph_targets(nodes_.json[node]); };
      rig_->clips = read_gltf_clips(file_, nodes_, targets, left_out_, model_.warnings);
    }
    rig_->nodes = nodes_.nodes;
    moved_ = moved_nodes(*rig_);
    for (std::size_t i = 0; i < nodes_.json.size(); ++i) instances_.push_back(read_instance(i));
    const RigPoser rest(*rig_, rest_pose(*rig_));
    rest_ = &rest;
    for (std::size_t i = 0; i < nodes_.json.size(); ++i) read_node(i);
    note_the_rest();
    if (rig_->instances.empty()) left_out_.add("animations that move nothing", rig_->clips.size());
    left_out_.warn(model_.warnings);
    textures_.warn(model_.warnings);
    if (!rig_->instances.empty()) model_.rig = rig_;
    return std::move(model_);
  }

 private:
  /// Morph targets of the first primitive of a node's mesh, which all of them share.
  [[nodiscard]] std::size_t morph_targets(const JsonView& node) const {
    const std::optional<JsonView> id = node.find("mesh");
    if (!id) return 0;
    const JsonView primitives = file_.element("meshes", *id).at("primitives");
    if (primitives.size() == 0) return 0;
    const std::optional<JsonView> targets = primitives.element(0).find("targets");
    return targets ? targets->size() : 0;
  }

  /// The instance of the rig that a node is, if something moves its mesh.
  std::optional<std::size_t> read_instance(std::size_t node) {
    const JsonView& json = nodes_.json[node];
    if (file_.version() != 2 || !json.find("mesh")) return std::nullopt;
    RigInstance instance{node, {}, std::vector<double>(morph_targets(json))};
    if (const std::optional<JsonView> skin = json.find("skin")) instance.skin = skin_of(*skin);
    if (!instance.skin && instance.morph_weights.empty() && !moved_[node]) return std::nullopt;
    const std::optional<JsonView> of_node = json.find("weights");
    const std::optional<JsonView> of_mesh = file_.element("meshes", json.at("mesh")).find("weights");
    if (const std::optional<JsonView>& weights = of_node ? of_node : of_mesh;
        weights && !instance.morph_weights.empty())
      instance.morph_weights = weights->numbers(instance.morph_weights.size(), instance.morph_weights.size());
    rig_->instances.push_back(instance);
    return rig_->instances.size() - 1;
  }

  std::size_t skin_of(const JsonView& id) {
    const auto [at, is_new] = skins_.try_emplace(file_.element("skins", id).place(), rig_->skins.size());
    if (is_new) rig_->skins.push_back(read_gltf_skin(file_, id, nodes_));
    return at->second;
  }

  void read_node(std::size_t number) {
    const JsonView& node = nodes_.json[number];
    if (file_.version() == 1 && (node.find("skin") || node.find("skeletons"))) left_out_.add("skins");
    note_extensions(node);
    if (const std::optional<JsonView> mesh = node.find("mesh")) read_mesh(number, *mesh);
    const std::optional<JsonView> several = node.find("meshes");  // of 1.0
    for (std::size_t i = 0; several && i < several->size(); ++i) read_mesh(number, several->element(i));
  }

  /// Instances of meshes (EXT_mesh_gpu_instancing), and whatever else nodes and primitives may ask for.
  void note_extensions(const JsonView& json) {
    const std::optional<JsonView> extensions = json.find("extensions");
    if (!extensions) return;
    for (const std::string& name : extensions->keys()) {
      if (name != "KHR_lights_punctual") left_out_.add(name);
    }
  }

  void read_mesh(std::size_t node, const JsonView& id) {
    const JsonView mesh = file_.element("meshes", id);
    std::vector<std::string> names;
    // The node is last, because parts are called by their last name and nodes may share a mesh.
    for (const std::string& name : {mesh.text_or("name", ""), nodes_.nodes[node].name}) {
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    const JsonView primitives = mesh.at("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      read_primitive(primitives.element(i), names, node);
    }
  }

  void read_primitive(const JsonView& json, const std::vector<std::string>& names, std::size_t node) {
    const std::int64_t mode = json.integer_or("mode", 4, 0, 6);
    if (mode < 4) {
      left_out_.add("points and lines");
      return;
    }
    const std::optional<std::size_t> instance = instances_[node];
    if (!instance && json.find("targets")) left_out_.add("morph targets");  // of 1.0
    note_extensions(json);
    const GltfMaterial material = material_of(json);
    const Primitive primitive = read_corners(json, mode, material.mapping.set);
    if (material.material.alpha_mode != AlphaMode::kOpaque)
      left_out_.add(kOpacityOfVertices, transparent_vertices(primitive.colours));
    std::optional<GltfVertices> moved;
    MovedBy moved_by;
    if (instance) {
      moved.emplace(read_vertices(json, primitive, *instance));
      moved_by.skin = rig_->instances[*instance].skin;
      if (moved->morph_targets() > 0) moved_by.morphing_instance = instance;
    }
    const std::uint32_t look = look_of(names, material.material, moved_by);
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      count_.add_face(3);
      std::array<std::size_t, 3> corners{primitive.indices[i], primitive.indices[i + 1],
                                         primitive.indices[i + 2]};
      std::array<std::uint32_t, 3> sources{kNoSource, kNoSource, kNoSource};
      if (moved) sources = moved->add_triangle(corners, *instance, rig_vertices_);
      std::array<CornerPlace, 3> places;
      for (std::size_t k = 0; k < 3; ++k) places[k] = place_of(primitive, corners[k], node, sources[k]);
      if (places[0].transform.mirrors()) {
        std::swap(corners[1], corners[2]);
        std::swap(places[1], places[2]);
      }
      add_triangle(json, primitive, corners, places, look, material);
    }
  }

  [[nodiscard]] CornerPlace place_of(const Primitive& primitive, std::size_t corner, std::size_t node,
                                     std::uint32_t source) const {
    CornerPlace at{rest_->nodes()[node], primitive.positions.vec3(corner), {}};
    if (primitive.normals) at.normal = primitive.normals->vec3(corner);
    if (source == kNoSource) return at;
    const RigVertex& vertex = rig_->vertices[source];
    at = {rest_->place(vertex), rest_->shaped_position(vertex), at.normal, source};
    if (finite(at.normal)) at.normal = rest_->shaped_normal(vertex);
    return at;
  }

  GltfVertices read_vertices(const JsonView& json, const Primitive& primitive, std::size_t instance) {
    const RigInstance& of = rig_->instances[instance];
    const std::size_t joints = of.skin ? rig_->skins[*of.skin].joints.size() : 0;
    GltfVertices vertices(file_, json, primitive.positions, primitive.normals, joints);
    if (vertices.morph_targets() != of.morph_weights.size())
      json.fail("has another number of morph targets than the first primitive of its mesh");
    if (vertices.weights()) {
      left_out_.add("weights above four for a vertex", vertices.weights()->with_many_weights());
      const std::size_t without = vertices.weights()->without_weights();
      if (without > 0) {
        model_.warnings.push_back(json.place() + ".attributes.WEIGHTS_0: vertices without a weight (" +
                                  std::to_string(without) + ") follow their first joint");
      }
    }
    return vertices;
  }

  Primitive read_corners(const JsonView& json, std::int64_t mode, std::int64_t texture_set) {
    const JsonView attributes = json.at("attributes");
    Primitive primitive{read_accessor(file_, attributes.at("POSITION"), 3, 3), {}, {}, {}, {}};
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
    const bool is_incomplete = mode == 4 ? corners.size() % 3 != 0 : corners.size() < 3;
    if (is_incomplete && !corners.empty()) left_out_.add("incomplete triangles");
    return primitive;
  }

  void add_triangle(const JsonView& json, const Primitive& primitive,
                    const std::array<std::size_t, 3>& corners, const std::array<CornerPlace, 3>& places,
                    std::uint32_t look, const GltfMaterial& material) {
    std::array<RawMesh::Corner, 3> triangle;
    TriangleColour colour{primitive.colours.has_value(), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      RawMesh::Corner& corner = triangle[i];
      const CornerPlace& place = places[i];
      corner.position = place.transform.point(place.position);
      corner.source = place.source;
      if (!finite(corner.position) || length(corner.position) > kMostCoordinate) {
        json.at("attributes").at("POSITION").fail("a coordinate is not a number up to 1e30");
      }
      if (primitive.normals) {
        const Vec3 normal = place.transform.normal(place.normal);
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
        const Vec3 c = primitive.colours->vec3(corners[i]);
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

  /// The look of a part. Instances with morph targets are parts of their own, because a part has one list of
  /// targets, and so are those of each skin, because a part has one list of joints.
  std::uint32_t look_of(const std::vector<std::string>& names, const FileMaterial& material,
                        const MovedBy& moved_by) {
    const PartLook look{names, material};
    for (std::size_t i = 0; i < model_.looks.size(); ++i) {
      if (model_.looks[i] == look && moved_by_[i] == moved_by) return static_cast<std::uint32_t>(i);
    }
    model_.looks.push_back(look);
    moved_by_.push_back(moved_by);
    return static_cast<std::uint32_t>(model_.looks.size() - 1);
  }

  void note_the_rest() {
    for (const char* list : {"animations", "cameras"}) {
      const std::optional<JsonView> all = file_.root().find(list);
      const bool is_read = file_.version() == 2 && list == std::string_view("animations");
      if (all && !is_read) left_out_.add(list, all->size());
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
  GltfNodes nodes_;
  LeftOut left_out_;
  std::shared_ptr<Rig> rig_ = std::make_shared<Rig>();
  RigVertices rig_vertices_{rig_->vertices};
  const RigPoser* rest_ = nullptr;                     ///< while meshes are read
  std::vector<bool> moved_;                            ///< nodes that a clip moves, or one above them
  std::vector<std::optional<std::size_t>> instances_;  ///< of each node
  std::vector<MovedBy> moved_by_;                      ///< of each look
  std::map<std::string, std::size_t> skins_;           ///< by place
};

}  // namespace

RawModel read_gltf(std::string_view bytes, const std::string& subject, const SideFiles& files) {
  return GltfReader(bytes, subject, files).read();
}

}  // namespace arcspan::tools
