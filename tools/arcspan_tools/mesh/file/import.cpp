// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/collada_text.hpp>
#include <arcspan_tools/mesh/file/fbx_scene.hpp>
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/mesh/file/loss_log.hpp>
#include <arcspan_tools/mesh/file/morph_keys.hpp>
#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>
#include <arcspan_tools/mesh/plain/triangulate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

const char* extension(MeshFormat format, std::string_view bytes) {
  if (format == MeshFormat::k3ds) return "3ds";
  if (format == MeshFormat::kFbx) return "fbx";
  return bytes.starts_with("PK\3\4") ? "zae" : "dae";  // an archive of a Collada file and its pictures
}

// The library guesses formats from content, too; with one loader left a file is what its name says.
void keep_only(Assimp::Importer& importer, const char* wanted) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    std::string names = " " + std::string(importer.GetImporterInfo(i)->mFileExtensions) + " ";
    if (names.find(" " + std::string(wanted) + " ") == std::string::npos) {
      others.push_back(importer.GetImporter(i));
    }
  }
  for (Assimp::BaseImporter* other : others) {
    importer.UnregisterLoader(other);
    delete other;  // unregistering hands the loader back to the caller
  }
}

template <class T>
nlohmann::json binary_of(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return nlohmann::json::binary(std::move(bytes));
}

nlohmann::json vectors(const aiVector3D* values, unsigned count) {
  std::vector<Vec3> all;
  for (unsigned i = 0; i < count; ++i) all.push_back({values[i].x, values[i].y, values[i].z});
  return binary_of(all);
}

/// Column after column.
nlohmann::json matrix_of(const aiMatrix4x4& m) {
  return binary_of(std::vector<double>{m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3,
                                       m.a4, m.b4, m.c4, m.d4});
}

/// Turns a scene of the library into JSON.
class SceneDump {
 public:
  SceneDump(const aiScene& scene, MeshFormat format, const LeftOutCounts& lost, bool knows_sets)
      : scene_(scene), format_(format), left_out_(lost), knows_sets_(knows_sets) {}

  nlohmann::json json() {
    list_nodes();
    const bool is_fbx = format_ == MeshFormat::kFbx;
    const aiMatrix4x4 space = is_fbx ? fbx_space(scene_) : aiMatrix4x4();
    if (is_fbx) joined_ = joined_fbx_nodes(scene_);
    nlohmann::json out{{"nodes", nlohmann::json::array()},
                       {"meshes", nlohmann::json::array()},
                       {"instances", nlohmann::json::array()},
                       {"looks", nlohmann::json::array()},
                       {"clips", nlohmann::json::array()}};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const aiNode& node = *nodes_[i];
      const auto joined = joined_.find(&node);
      const aiMatrix4x4 own = joined == joined_.end() ? node.mTransformation : joined->second.transform;
      const aiMatrix4x4 matrix = i == 0 ? space * own : own;
      out["nodes"].push_back(
          {{"name", node.mName.C_Str()}, {"parent", parents_[i]}, {"matrix", matrix_of(matrix)}});
      for (unsigned k = 0; k < node.mNumMeshes; ++k) {
        const unsigned mesh = node.mMeshes[k];
        out["instances"].push_back({i, mesh});
        out["looks"].push_back(look_of(*scene_.mMeshes[mesh], node));
      }
    }
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i)
      out["meshes"].push_back(mesh_of(*scene_.mMeshes[i], space_of_mesh(i)));
    for (unsigned i = 0; i < scene_.mNumAnimations; ++i)
      out["clips"].push_back(clip_of(*scene_.mAnimations[i]));
    out["pictures"] = pictures_;
    out["left_out"] = left_out_;
    out["ambiguous"] = ambiguous_;
    return out;
  }

 private:
  /// Parents before their children.
  void list_nodes() {
    std::vector<std::pair<const aiNode*, std::int64_t>> open{{scene_.mRootNode, -1}};
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      if (node == nullptr) continue;
      const auto number = static_cast<std::int64_t>(nodes_.size());
      const auto [at, is_new] = numbers_.try_emplace(node->mName.C_Str(), nodes_.size());
      if (!is_new) shared_names_.insert(at->first);
      nodes_.push_back(node);
      parents_.push_back(parent);
      for (unsigned i = node->mNumChildren; i > 0; --i) open.push_back({node->mChildren[i - 1], number});
    }
  }

  /// The first node of a name, or -1.
  std::int64_t number_of(const std::string& name) {
    const auto found = numbers_.find(name);
    if (found == numbers_.end()) return -1;
    if (shared_names_.count(name) != 0) ambiguous_.insert(name);
    return static_cast<std::int64_t>(found->second);
  }

  void leave_out(const char* kind) { ++left_out_[kind]; }

  /// Whether a material is `constant` of Collada: it has no colour under light, only emission.
  [[nodiscard]] bool is_constant(const aiMaterial& material) const {
    int model = 0;
    return format_ == MeshFormat::kCollada &&
           material.Get(AI_MATKEY_SHADING_MODEL, model) == aiReturn_SUCCESS &&
           model == aiShadingMode_NoShading;
  }

  /// The names and the material of a mesh, as the importing library describes them.
  nlohmann::json look_of(const aiMesh& mesh, const aiNode& node) {
    nlohmann::json look{
        {"names", nlohmann::json::array()}, {"material", ""}, {"two_sided", false}, {"unlit", false}};
    for (const aiString& name : {mesh.mName, node.mName}) {
      if (name.length > 0) look["names"].push_back(name.C_Str());
    }
    if (mesh.mMaterialIndex >= scene_.mNumMaterials) return look;
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    aiString text;
    if (material.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) look["material"] = text.C_Str();
    int two_sided = 0;
    if (material.Get(AI_MATKEY_TWOSIDED, two_sided) == aiReturn_SUCCESS) look["two_sided"] = two_sided != 0;
    const auto number = [&](const char* name, unsigned type, unsigned index) -> std::optional<double> {
      ai_real value = 0;
      if (material.Get(name, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value))
        return std::nullopt;
      return value;
    };
    const auto add_colour = [&](const char* key, double factor, const char* name, unsigned type,
                                unsigned index) {
      aiColor3D c;
      if (material.Get(name, type, index, c) != aiReturn_SUCCESS) return;
      if (std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b))
        look[key] = {c.r * factor, c.g * factor, c.b * factor};
    };
    const bool is_fbx = format_ == MeshFormat::kFbx;
    const bool unlit = is_constant(material);
    look["unlit"] = unlit;
    if (!unlit) add_colour("diffuse", 1, AI_MATKEY_COLOR_DIFFUSE);
    add_colour(unlit ? "diffuse" : "emission", 1, AI_MATKEY_COLOR_EMISSIVE);
    add_colour("specular", is_fbx ? number(AI_MATKEY_SHININESS_STRENGTH).value_or(1) : 1,
               AI_MATKEY_COLOR_SPECULAR);
    if (const auto shininess = number(AI_MATKEY_SHININESS)) look["shininess"] = *shininess;
    // Opacity of Collada and 3DS is left out, because exporters write it in two opposite ways. 0 and 1 may
    // both mean opaque.
    const auto opacity = number(AI_MATKEY_OPACITY);
    if (is_fbx && opacity) look["opacity"] = *opacity;
    if (!is_fbx && opacity > 0 && opacity < 1) leave_out("opacity of materials");
    const auto type = drawn_texture(material);
    if (type && material.GetTexture(*type, 0, &text) == aiReturn_SUCCESS) {
      look["texture"] = text.C_Str();
      if (is_fbx && moves_texture(material, *type)) leave_out("scales, shifts and turns of textures");
      add_picture(text);
    }
    return look;
  }

  [[nodiscard]] static bool moves_texture(const aiMaterial& material, aiTextureType type) {
    aiUVTransform is;
    if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), is) != aiReturn_SUCCESS) return false;
    return is.mTranslation != aiVector2D() || is.mScaling != aiVector2D(1, 1) || is.mRotation != 0;
  }

  [[nodiscard]] std::optional<aiTextureType> drawn_texture(const aiMaterial& material) const {
    for (const aiTextureType type :
         {is_constant(material) ? aiTextureType_EMISSIVE : aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
      if (material.GetTextureCount(type) > 0) return type;
    }
    return std::nullopt;
  }

  /// Which texture coordinates of a mesh its texture refers to.
  [[nodiscard]] unsigned texture_set_of(const aiMesh& mesh) const {
    if (!knows_sets_ || mesh.mMaterialIndex >= scene_.mNumMaterials) return 0;
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    const auto type = drawn_texture(material);
    int set = 0;
    if (!type || material.Get(AI_MATKEY_UVWSRC(*type, 0), set) != aiReturn_SUCCESS || set < 0) return 0;
    auto number = static_cast<unsigned>(set);
    if (format_ == MeshFormat::kFbx) number = set_in(mesh, number);
    return mesh.HasTextureCoords(number) ? number : 0;
  }

  /// Textures of FBX name a set. The library looks up its number in the first mesh of the material only.
  [[nodiscard]] unsigned set_in(const aiMesh& mesh, unsigned number) const {
    const aiMesh& first =
        **std::find_if(scene_.mMeshes, scene_.mMeshes + scene_.mNumMeshes,
                       [&](const aiMesh* m) { return m->mMaterialIndex == mesh.mMaterialIndex; });
    if (!first.HasTextureCoordsName(number)) return number;
    for (unsigned i = 0; mesh.HasTextureCoords(i); ++i) {
      if (mesh.HasTextureCoordsName(i) &&
          *mesh.GetTextureCoordsName(i) == *first.GetTextureCoordsName(number))
        return i;
    }
    return 0;
  }

  /// Keeps the bytes of a picture that the file holds.
  void add_picture(const aiString& name) {
    const aiTexture* picture = scene_.GetEmbeddedTexture(name.C_Str());
    if (picture == nullptr || picture->mHeight != 0 || pictures_.contains(name.C_Str())) return;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(picture->pcData);
    pictures_[name.C_Str()] = binary_of(std::vector<std::uint8_t>(bytes, bytes + picture->mWidth));
  }

  /// From a mesh to the space of the offset matrices of its bones.
  [[nodiscard]] aiMatrix4x4 space_of_mesh(unsigned mesh) const {
    if (format_ != MeshFormat::kFbx || !scene_.mMeshes[mesh]->HasBones()) return {};
    for (const aiNode* node : nodes_) {
      const std::span<const unsigned> meshes(node->mMeshes, node->mNumMeshes);
      if (std::find(meshes.begin(), meshes.end(), mesh) != meshes.end()) return geometric_transform(*node);
    }
    return {};
  }

  nlohmann::json mesh_of(const aiMesh& mesh, const aiMatrix4x4& space) {
    nlohmann::json out{{"positions", vectors(mesh.mVertices, mesh.mNumVertices)},
                       {"joints", nlohmann::json::array()},
                       {"targets", nlohmann::json::array()}};
    if (mesh.HasNormals()) out["normals"] = vectors(mesh.mNormals, mesh.mNumVertices);
    const unsigned set = texture_set_of(mesh);
    if (mesh.HasTextureCoords(set)) {
      std::vector<Uv> points;  // the library's v is up
      for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        points.push_back({mesh.mTextureCoords[set][i].x, 1.0 - mesh.mTextureCoords[set][i].y});
      out["texture_points"] = binary_of(points);
    }
    if (mesh.HasVertexColors(0)) leave_out("vertex colours");
    std::vector<std::uint32_t> corners;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) add_face(corners, mesh, mesh.mFaces[f]);
    out["corners"] = binary_of(corners);
    for (unsigned i = 0; i < mesh.mNumBones; ++i) add_joint(out["joints"], *mesh.mBones[i], space);
    for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i) {
      const aiAnimMesh& target = *mesh.mAnimMeshes[i];
      nlohmann::json& json = out["targets"].emplace_back(nlohmann::json::object());
      // The library gives targets of FBX a weight of 1, whatever the file says.
      json["weight"] = format_ == MeshFormat::kFbx ? 0.0 : double(target.mWeight);
      json["is_offset"] = mesh.mMethod == aiMorphingMethod_MORPH_RELATIVE;
      if (target.HasPositions()) json["positions"] = vectors(target.mVertices, target.mNumVertices);
      if (target.HasNormals()) json["normals"] = vectors(target.mNormals, target.mNumVertices);
    }
    return out;
  }

  /// Adds the triangles of a face. Those of Assimp fill the notches of some polygons.
  void add_face(std::vector<std::uint32_t>& corners, const aiMesh& mesh, const aiFace& face) {
    if (face.mNumIndices < 3) return;  // points and lines
    if (face.mNumIndices > kMostCorners) return leave_out("faces of too many corners");
    std::vector<Vec3> polygon;
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const aiVector3D& p = mesh.mVertices[face.mIndices[i]];
      polygon.push_back({p.x, p.y, p.z});
    }
    for (const std::array<std::uint32_t, 3>& triangle : triangulated(polygon)) {
      for (const std::uint32_t corner : triangle) corners.push_back(face.mIndices[corner]);
    }
  }

  void add_joint(nlohmann::json& joints, const aiBone& bone, const aiMatrix4x4& space) {
    const std::int64_t node = number_of(bone.mName.C_Str());
    if (node < 0) return leave_out("joints that are not in the scene");
    std::vector<std::uint32_t> vertices;
    std::vector<double> weights;
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      vertices.push_back(bone.mWeights[i].mVertexId);
      weights.push_back(bone.mWeights[i].mWeight);
    }
    joints.push_back({{"node", node},
                      {"inverse_bind", matrix_of(bone.mOffsetMatrix * space)},
                      {"vertices", binary_of(vertices)},
                      {"weights", binary_of(weights)}});
  }

  nlohmann::json clip_of(const aiAnimation& clip) {
    constexpr double kUsualTicks = 25;  // per second, where the file gives none
    ticks_ = clip.mTicksPerSecond > 0 ? clip.mTicksPerSecond : kUsualTicks;
    nlohmann::json channels = nlohmann::json::array();
    const auto vector = [](const aiVector3D& v) { return std::vector<double>{v.x, v.y, v.z}; };
    for (unsigned i = 0; i < clip.mNumChannels; ++i) {
      const aiNodeAnim& channel = *clip.mChannels[i];
      const std::int64_t node = number_of(channel.mNodeName.C_Str());
      if (node < 0) {
        leave_out("animated nodes that are not in the scene");
        continue;
      }
      const auto joined = joined_.find(nodes_[static_cast<std::size_t>(node)]);
      const aiQuaternion after = joined == joined_.end() ? aiQuaternion() : joined->second.after;
      add_channel(channels, node, ChannelPath::kTranslation, channel.mPositionKeys, channel.mNumPositionKeys,
                  vector);
      add_channel(channels, node, ChannelPath::kRotation, channel.mRotationKeys, channel.mNumRotationKeys,
                  [after](const aiQuaternion& key) {
                    const aiQuaternion q = key * after;
                    return std::vector<double>{q.x, q.y, q.z, q.w};
                  });
      add_channel(channels, node, ChannelPath::kScale, channel.mScalingKeys, channel.mNumScalingKeys, vector);
    }
    for (unsigned i = 0; i < clip.mNumMorphMeshChannels; ++i)
      add_morph_channel(channels, *clip.mMorphMeshChannels[i]);
    return {{"name", clip.mName.C_Str()}, {"channels", channels}};
  }

  template <class Key, class Numbers>
  void add_channel(nlohmann::json& channels, std::int64_t node, ChannelPath path, const Key* keys,
                   unsigned count, const Numbers& numbers) {
    std::vector<double> times;
    std::vector<double> values;
    for (unsigned i = 0; i < count; ++i) {
      // Where two keys have the same time, the later one in the list is used.
      if (i + 1 < count && keys[i + 1].mTime == keys[i].mTime) continue;
      times.push_back(keys[i].mTime / ticks_);
      const std::vector<double> value = numbers(keys[i].mValue);
      values.insert(values.end(), value.begin(), value.end());
    }
    if (times.empty()) return;
    channels.push_back({{"node", node},
                        {"path", static_cast<int>(path)},
                        {"times", binary_of(times)},
                        {"values", binary_of(values)}});
  }

  void add_morph_channel(nlohmann::json& channels, const aiMeshMorphAnim& channel) {
    const std::string name = channel.mName.C_Str();
    const std::int64_t node = number_of(name.substr(0, name.rfind('*')));  // the library adds *0, *1...
    const aiNode* at = node < 0 ? nullptr : nodes_[static_cast<std::size_t>(node)];
    if (at == nullptr || at->mNumMeshes == 0) return leave_out("animated meshes that are not in the scene");
    const std::size_t targets =
        std::min<std::size_t>(scene_.mMeshes[at->mMeshes[0]]->mNumAnimMeshes, kMostMorphTargets);
    std::vector<MorphKey> keys;
    for (unsigned i = 0; i < channel.mNumKeys; ++i) {
      const aiMeshMorphKey& key = channel.mKeys[i];
      keys.push_back({key.mTime, std::vector<double>(targets), std::vector<bool>(targets)});
      for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
        if (key.mValues[k] >= targets) continue;
        keys.back().mValue[key.mValues[k]] = key.mWeights[k];
        keys.back().is_given[key.mValues[k]] = true;
      }
    }
    fill_in_weights(keys);
    add_channel(channels, node, ChannelPath::kMorphWeights, keys.data(), static_cast<unsigned>(keys.size()),
                [](const std::vector<double>& weights) { return weights; });
  }

  const aiScene& scene_;
  MeshFormat format_;
  LeftOutCounts left_out_;
  bool knows_sets_;  ///< whether materials tell which texture coordinates they use
  std::vector<const aiNode*> nodes_{};
  std::vector<std::int64_t> parents_{};
  std::map<const aiNode*, JoinedNode> joined_{};
  std::map<std::string, std::size_t> numbers_{};  ///< of the first node of each name
  std::set<std::string> shared_names_{};
  std::set<std::string> ambiguous_{};  ///< shared names that something refers to
  nlohmann::json pictures_ = nlohmann::json::object();
  double ticks_ = 1;  ///< per second, in the current clip
};

/// The library's complaint. Its exceptions of the standard library say nothing to a user.
std::string complaint(const std::string& text) {
  if (text.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  if (text.find("unsupported, old format version") != std::string::npos)
    return "FBX before version 7.1 cannot be read; export it as FBX 2011 or later";
  const bool is_sentence = text.find(' ') != std::string::npos && text.find("::") == std::string::npos;
  return "cannot be read: " + (is_sentence ? text : "damaged");
}

}  // namespace

std::string import_scene(std::string_view bytes, MeshFormat format, const std::string& subject) {
  Assimp::Importer importer;
  const char* wanted = extension(format, bytes);
  keep_only(importer, wanted);
  std::string text;
  LeftOutCounts lost;
  const bool is_text = wanted == std::string_view("dae");
  if (is_text) {
    bytes = text = with_numbered_sets(without_blanks_before_numbers(bytes));
    if (const std::size_t joints = count_shared_joints(bytes); joints != 0)
      lost["joints with the sid of another, which meshes follow in their place"] = joints;
  }
  // Else the library draws a body around the nodes of a file that has no mesh.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const WithLossLog log(lost);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, wanted);
  if (scene == nullptr) throw Failure(subject, complaint(importer.GetErrorString()));
  std::string cbor;
  const bool knows_sets = is_text || format == MeshFormat::kFbx;
  nlohmann::json::to_cbor(SceneDump(*scene, format, lost, knows_sets).json(), cbor);
  return cbor;
}

}  // namespace arcspan::tools
