// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/file_pictures.hpp>
#include <arcspan_tools/mesh/file/join_nodes.hpp>
#include <arcspan_tools/mesh/file/left_out.hpp>
#include <arcspan_tools/mesh/file/scene_clips.hpp>
#include <arcspan_tools/mesh/file/scene_looks.hpp>
#include <arcspan_tools/mesh/file/scene_model.hpp>
#include <arcspan_tools/mesh/file/scene_numbers.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/mesh/plain/rig_vertices.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace arcspan::tools {
namespace {

/// A mesh of a scene. A vertex is an index into each of these lists, unless that is empty.
struct SceneMesh {
  struct Joint {
    std::size_t node = 0;
    Affine inverse_bind{};
  };
  struct Target {
    std::vector<Vec3> positions;  ///< offsets from those of the mesh
    std::vector<Vec3> normals;
  };
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Uv> texture_points;
  std::vector<std::uint32_t> corners;  ///< three of each triangle
  std::vector<Joint> joints;
  std::vector<JointWeights> weights;
  std::vector<Target> targets;
  std::vector<double> target_weights;
};

struct SceneInstance {
  std::size_t node = 0;
  const SceneMesh* mesh = nullptr;
  Affine place{};                      ///< from the mesh to the space in which the rig stores its vertices
  std::optional<std::size_t> moved{};  ///< the instance of the rig, if something moves it
};

Affine matrix_of(const nlohmann::json& object, const char* name) {
  std::vector<double> numbers = scene_numbers<double>(object, name);
  numbers.resize(16);
  return affine_of(numbers.data());
}

bool is_finite(const Affine& m) { return finite(m.x) && finite(m.y) && finite(m.z) && finite(m.translation); }

class SceneReader {
 public:
  SceneReader(const nlohmann::json& scene, const std::string& subject, const SideFiles& files)
      : scene_(scene), subject_(subject), files_(files), count_(subject) {}

  RawModel read() {
    model_.looks = scene_looks(scene_, files_, model_.warnings);
    for (const auto& [kind, count] : scene_["left_out"].items())
      left_out_.add(kind, count.get<std::size_t>());
    read_nodes();
    for (const nlohmann::json& mesh : scene_["meshes"]) meshes_.push_back(read_mesh(mesh));
    for (const nlohmann::json& pair : scene_["instances"])
      instances_.push_back(
          {index(pair[0], rig_->nodes.size()), &meshes_[index(pair[1], meshes_.size())], {}, {}});
    const auto targets = [this](std::size_t node) { return morph_targets(node); };
    rig_->clips = scene_clips(scene_, rig_->nodes, targets, model_.warnings);
    join_nodes();
    const std::vector<bool> moved = moved_nodes(*rig_);
    rest_places_ = RigPoser(*rig_, rest_pose(*rig_)).nodes();
    for (SceneInstance& instance : instances_) add_instance(instance, moved[instance.node]);
    const RigPoser rest(*rig_, rest_pose(*rig_));
    for (std::size_t i = 0; i < instances_.size(); ++i)
      add_triangles(instances_[i], rest, static_cast<std::uint32_t>(i));
    if (model_.mesh.triangles.empty()) refuse_empty();
    warn();
    if (!rig_->instances.empty()) model_.rig = rig_;
    return std::move(model_);
  }

 private:
  void refuse_damaged() const { throw Failure(subject_, "the mesh loader returned a damaged scene"); }

  void refuse_empty() const {
    std::vector<std::string> lines;
    left_out_.warn(lines);
    throw Failure(subject_, lines.empty() ? "no faces" : "no faces; " + lines[0]);
  }

  /// An index below `end`. The loader's process reads files of strangers, so that it is checked.
  std::size_t index(const nlohmann::json& json, std::size_t end) const {
    const auto found = json.get<std::size_t>();
    if (found >= end) refuse_damaged();
    return found;
  }

  void read_nodes() {
    for (const nlohmann::json& json : scene_["nodes"]) {
      RigNode node;
      node.name = json["name"].get<std::string>();
      node.matrix = matrix_of(json, "matrix");
      if (!is_finite(*node.matrix))
        throw Failure(subject_, "the matrix of the node " + in_quotes(node.name) + " is not finite");
      if (json["parent"].get<std::int64_t>() >= 0) node.parent = index(json["parent"], rig_->nodes.size());
      rig_->nodes.push_back(node);
    }
  }

  void join_nodes() {
    std::vector<bool> kept(rig_->nodes.size());
    for (const SceneInstance& instance : instances_) kept[instance.node] = true;
    for (const SceneMesh& mesh : meshes_) {
      for (const SceneMesh::Joint& joint : mesh.joints) kept[joint.node] = true;
    }
    const std::vector<std::size_t> numbers = join_pivot_nodes(*rig_, kept);
    for (SceneInstance& instance : instances_) instance.node = numbers[instance.node];
    for (SceneMesh& mesh : meshes_) {
      for (SceneMesh::Joint& joint : mesh.joints) joint.node = numbers[joint.node];
    }
  }

  SceneMesh read_mesh(const nlohmann::json& json) {
    SceneMesh mesh;
    mesh.positions = scene_numbers<Vec3>(json, "positions");
    mesh.normals = scene_numbers<Vec3>(json, "normals");
    mesh.texture_points = scene_numbers<Uv>(json, "texture_points");
    mesh.corners = scene_numbers<std::uint32_t>(json, "corners");
    for (const std::size_t count : {mesh.normals.size(), mesh.texture_points.size()}) {
      if (count != 0 && count != mesh.positions.size()) refuse_damaged();
    }
    for (const std::uint32_t corner : mesh.corners) {
      if (corner < mesh.positions.size()) continue;
      throw Failure(subject_, "face index out of range (" + std::to_string(corner) + " of " +
                                  std::to_string(mesh.positions.size()) + " vertices)");
    }
    for (const nlohmann::json& joint : json["joints"]) read_joint(mesh, joint);
    for (const nlohmann::json& target : json["targets"]) read_target(mesh, target);
    return mesh;
  }

  void read_joint(SceneMesh& mesh, const nlohmann::json& json) {
    const SceneMesh::Joint joint{index(json["node"], rig_->nodes.size()), matrix_of(json, "inverse_bind")};
    if (!is_finite(joint.inverse_bind)) return left_out_.add("joints with a matrix that is not finite");
    mesh.weights.resize(mesh.positions.size());
    const auto vertices = scene_numbers<std::uint32_t>(json, "vertices");
    const auto weights = scene_numbers<double>(json, "weights");
    for (std::size_t i = 0; i < std::min(vertices.size(), weights.size()); ++i) {
      if (vertices[i] < mesh.weights.size() && weights[i] >= 0 && std::isfinite(weights[i])) {
        mesh.weights[vertices[i]].add(mesh.joints.size(), weights[i]);
      } else {
        left_out_.add("weights that are wrong");
      }
    }
    mesh.joints.push_back(joint);
  }

  void read_target(SceneMesh& mesh, const nlohmann::json& json) {
    if (mesh.targets.size() == kMostMorphTargets) return left_out_.add("morph targets above 256");
    SceneMesh::Target target{scene_numbers<Vec3>(json, "positions"), scene_numbers<Vec3>(json, "normals")};
    const bool is_offset = json["is_offset"].get<bool>();
    const auto make_offsets = [is_offset](std::vector<Vec3>& values, const std::vector<Vec3>& base) {
      if (values.size() != base.size()) return values.assign(base.size(), {});
      for (std::size_t i = 0; i < base.size(); ++i) {
        const Vec3 offset = is_offset ? values[i] : values[i] - base[i];
        values[i] = finite(offset) ? offset : Vec3{};
      }
    };
    make_offsets(target.positions, mesh.positions);
    make_offsets(target.normals, mesh.normals);
    mesh.targets.push_back(std::move(target));
    const auto weight = json["weight"].get<double>();
    mesh.target_weights.push_back(std::isfinite(weight) ? weight : 0);
  }

  /// Morph targets of the meshes of a node; 0 if these have different numbers.
  [[nodiscard]] std::size_t morph_targets(std::size_t node) const {
    std::optional<std::size_t> count;
    for (const SceneInstance& instance : instances_) {
      if (instance.node != node) continue;
      const std::size_t own = instance.mesh->targets.size();
      if (count.value_or(own) != own) return 0;
      count = own;
    }
    return count.value_or(0);
  }

  void add_instance(SceneInstance& instance, bool is_moved) {
    const SceneMesh& mesh = *instance.mesh;
    if (mesh.joints.empty() && mesh.targets.empty() && !is_moved) return;
    RigInstance of{instance.node, {}, mesh.target_weights};
    if (!mesh.joints.empty()) {
      of.skin = rig_->skins.size();
      rig_->skins.push_back(skin_of(instance));
    }
    instance.moved = rig_->instances.size();
    rig_->instances.push_back(of);
  }

  /// Also sets `place`: vertices are stored where the first joint holds them at rest, because an uneven scale
  /// of the mesh would turn normals.
  RigSkin skin_of(SceneInstance& instance) {
    const SceneMesh& mesh = *instance.mesh;
    const Affine place = rest_places_[mesh.joints[0].node] * mesh.joints[0].inverse_bind;
    const std::optional<Affine> back = inverse(place);
    if (back) instance.place = place;
    RigSkin skin;
    for (const SceneMesh::Joint& joint : mesh.joints) {
      skin.joints.push_back(joint.node);
      skin.inverse_bind.push_back(back ? joint.inverse_bind * *back : joint.inverse_bind);
    }
    // Vertices without a weight follow the node of their mesh.
    const auto is_free = [](const JointWeights& weights) { return weights.count() == 0; };
    if (std::any_of(mesh.weights.begin(), mesh.weights.end(), is_free)) {
      skin.joints.push_back(instance.node);
      skin.inverse_bind.push_back(back.value_or(Affine{}));
    }
    return skin;
  }

  RigVertex vertex(const SceneInstance& instance, std::size_t i) const {
    const SceneMesh& mesh = *instance.mesh;
    RigVertex vertex;
    vertex.instance = *instance.moved;
    const Affine& place = instance.place;
    vertex.position = place.point(mesh.positions[i]);
    const auto normal_at = [&](const std::vector<Vec3>& normals) {
      const Vec3 normal = normals.empty() ? Vec3{} : place.normal(normals[i]);
      return finite(normal) ? normal : Vec3{};
    };
    vertex.normal = normal_at(mesh.normals);
    const double size = length(vertex.normal);
    if (size > 0) vertex.normal = vertex.normal * (1 / size);
    if (!mesh.joints.empty()) {
      JointWeights weights = mesh.weights[i];
      if (weights.count() == 0) weights.add(mesh.joints.size(), 1);
      weights.bind(vertex);
    }
    for (const SceneMesh::Target& target : mesh.targets) {
      const Vec3 turn = size > 0 ? normal_at(target.normals) * (1 / size) : Vec3{};
      vertex.deltas.push_back({place.direction(target.positions[i]), turn});
    }
    return vertex;
  }

  std::uint32_t add_vertex(const SceneInstance& instance, std::size_t i) {
    const std::size_t known = rig_->vertices.size();
    const std::uint32_t number = rig_vertices_.add(vertex(instance, i));
    const std::vector<JointWeights>& weights = instance.mesh->weights;
    const bool has_many = !weights.empty() && weights[i].count() > kMostWeights;
    if (has_many && number == known) left_out_.add("weights above four for a vertex");
    return number;
  }

  void add_triangles(const SceneInstance& instance, const RigPoser& rest, std::uint32_t look) {
    const SceneMesh& mesh = *instance.mesh;
    std::map<std::uint32_t, std::uint32_t> known;  // vertices of the rig, by index
    bool mirrors = false;
    const auto corner_of = [&](std::uint32_t i) {
      RawMesh::Corner corner;
      Affine place = rest_places_[instance.node];
      Vec3 position = mesh.positions[i];
      Vec3 normal = mesh.normals.empty() ? Vec3{} : mesh.normals[i];
      if (instance.moved) {
        const auto [found, is_new] = known.try_emplace(i);
        if (is_new) found->second = add_vertex(instance, i);
        corner.source = found->second;
        const RigVertex& moved = rig_->vertices[corner.source];
        place = rest.place(moved);
        position = rest.shaped_position(moved);
        normal = rest.shaped_normal(moved);
      }
      mirrors = place.mirrors();
      corner.position = place.point(position);
      if (!finite(corner.position) || length(corner.position) > kMostCoordinate)
        throw Failure(subject_, "a coordinate is not a number up to 1e30");
      if (const Vec3 turned = place.normal(normal); finite(turned)) corner.normal = turned;
      if (mesh.texture_points.empty()) return corner;
      const Uv& point = mesh.texture_points[i];
      if (std::isfinite(point.u) && std::isfinite(point.v)) {
        corner.texture_point = point;
      } else {
        left_out_.add(kWrongTexturePoints);
      }
      return corner;
    };
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
      count_.add_face(3);
      std::array<RawMesh::Corner, 3> triangle{corner_of(mesh.corners[i]), corner_of(mesh.corners[i + 1]),
                                              corner_of(mesh.corners[i + 2])};
      if (mirrors) std::swap(triangle[1], triangle[2]);
      model_.mesh.triangles.push_back(triangle);
      model_.look_of.push_back(look);
    }
  }

  void warn() {
    left_out_.warn(model_.warnings);
    std::vector<std::string> ambiguous;
    for (const nlohmann::json& name : scene_["ambiguous"]) ambiguous.push_back(name.get<std::string>());
    if (ambiguous.empty()) return;
    model_.warnings.push_back(
        "of several nodes with the same name only the first is moved by joints and clips: " +
        quoted_list(ambiguous));
  }

  const nlohmann::json& scene_;
  std::string subject_;
  const SideFiles& files_;
  TriangleCount count_;
  RawModel model_{};
  LeftOut left_out_{};
  std::vector<SceneMesh> meshes_{};
  std::vector<SceneInstance> instances_{};
  std::vector<Affine> rest_places_{};  ///< of all nodes
  std::shared_ptr<Rig> rig_ = std::make_shared<Rig>();
  RigVertices rig_vertices_{rig_->vertices};
};

}  // namespace

RawModel scene_model(const std::string& imported, const std::string& subject, const SideFiles& files) {
  const nlohmann::json scene = nlohmann::json::from_cbor(imported, true, false);
  if (scene.is_discarded()) throw Failure(subject, "the mesh loader was interrupted");
  return SceneReader(scene, subject, files).read();
}

}  // namespace arcspan::tools
