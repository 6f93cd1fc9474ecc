// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/import.hpp>
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
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

const char* extension(MeshFormat format) { return format == MeshFormat::kCollada ? "dae" : "3ds"; }

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

Vec3 to_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// The names and the material of a mesh, as the importing library describes them.
nlohmann::json look_of(const aiMesh& mesh, const aiNode& node, const aiScene& scene) {
  nlohmann::json look{{"names", nlohmann::json::array()}, {"material", ""}, {"two_sided", false}};
  for (const aiString& name : {mesh.mName, node.mName}) {
    if (name.length > 0) look["names"].push_back(name.C_Str());
  }
  if (mesh.mMaterialIndex >= scene.mNumMaterials) return look;
  const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
  aiString text;
  if (material.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) look["material"] = text.C_Str();
  int two_sided = 0;
  if (material.Get(AI_MATKEY_TWOSIDED, two_sided) == aiReturn_SUCCESS) look["two_sided"] = two_sided != 0;
  const auto add_colour = [&](const char* key, const char* name, unsigned type, unsigned index) {
    aiColor3D c;
    if (material.Get(name, type, index, c) != aiReturn_SUCCESS) return;
    if (std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b)) look[key] = {c.r, c.g, c.b};
  };
  add_colour("diffuse", AI_MATKEY_COLOR_DIFFUSE);
  add_colour("specular", AI_MATKEY_COLOR_SPECULAR);
  add_colour("emission", AI_MATKEY_COLOR_EMISSIVE);
  ai_real shininess = 0;
  if (material.Get(AI_MATKEY_SHININESS, shininess) == aiReturn_SUCCESS && std::isfinite(shininess)) {
    look["shininess"] = shininess;
  }
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &text) == aiReturn_SUCCESS)
    look["texture"] = text.C_Str();
  return look;
}

struct ImportedScene {
  std::vector<std::array<RawMesh::Corner, 3>> triangles;
  std::vector<std::uint32_t> look_of;
  nlohmann::json looks = nlohmann::json::array();
};

/// Adds a mesh of a scene, moved by its node's transform. The library's v is up.
void append(ImportedScene& out, const aiMesh& mesh, const aiMatrix4x4& transform,
            const std::string& subject) {
  aiMatrix3x3 of_normals(transform);
  const bool mirrors = of_normals.Determinant() < 0;
  of_normals.Inverse().Transpose();
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    std::array<RawMesh::Corner, 3> corners;
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned index = face.mIndices[i];
      if (index >= mesh.mNumVertices) {
        throw Failure(subject, "face index out of range (" + std::to_string(index) + " of " +
                                   std::to_string(mesh.mNumVertices) + " vertices)");
      }
      corners[i].position = to_vec3(transform * mesh.mVertices[index]);
      if (!finite(corners[i].position)) throw Failure(subject, "a coordinate is not a finite number");
      if (mesh.HasNormals()) {
        const Vec3 normal = to_vec3(of_normals * mesh.mNormals[index]);
        corners[i].normal = finite(normal) ? normal : Vec3{};
      }
      if (mesh.HasTextureCoords(0)) {
        const aiVector3D& point = mesh.mTextureCoords[0][index];
        corners[i].texture_point = Uv{point.x, 1.0 - point.y};
      }
    }
    if (mirrors) std::swap(corners[1], corners[2]);
    out.triangles.push_back(corners);
    out.look_of.push_back(static_cast<std::uint32_t>(out.looks.size()));
  }
}

ImportedScene meshes_of(const aiScene& scene, const std::string& subject) {
  struct Visit {
    const aiNode* node;
    aiMatrix4x4 parent;
  };
  ImportedScene out;
  std::vector<Visit> open{{scene.mRootNode, {}}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    if (visit.node == nullptr) continue;
    const aiMatrix4x4 transform = visit.parent * visit.node->mTransformation;
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[visit.node->mMeshes[i]];
      append(out, mesh, transform, subject);
      out.looks.push_back(look_of(mesh, *visit.node, scene));
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      open.push_back({visit.node->mChildren[i - 1], transform});
    }
  }
  return out;
}

/// The numbers of joints, morph targets and clips in a scene, which are not imported.
nlohmann::json left_out_of(const aiScene& scene) {
  std::size_t joints = 0;
  std::size_t targets = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    joints += scene.mMeshes[i]->mNumBones;
    targets += scene.mMeshes[i]->mNumAnimMeshes;
  }
  return {{"joints", joints}, {"morph targets", targets}, {"clips", scene.mNumAnimations}};
}

template <class T>
nlohmann::json binary_of(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return nlohmann::json::binary(std::move(bytes));
}

/// The library's complaint. Its exceptions of the standard library say nothing to a user.
std::string complaint(const std::string& text) {
  if (text.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  const bool is_sentence = text.find(' ') != std::string::npos && text.find("::") == std::string::npos;
  return "cannot be read: " + (is_sentence ? text : "damaged");
}

}  // namespace

std::string import_scene(std::string_view bytes, MeshFormat format, const std::string& subject) {
  Assimp::Importer importer;
  keep_only(importer, extension(format));
  const aiScene* scene =
      importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, extension(format));
  if (scene == nullptr) throw Failure(subject, complaint(importer.GetErrorString()));
  const ImportedScene all = meshes_of(*scene, subject);
  std::string cbor;
  nlohmann::json::to_cbor({{"triangles", binary_of(all.triangles)},
                           {"look_of", binary_of(all.look_of)},
                           {"looks", all.looks},
                           {"left_out", left_out_of(*scene)}},
                          cbor);
  return cbor;
}

}  // namespace arcspan::tools
