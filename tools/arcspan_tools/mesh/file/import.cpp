// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

const char* extension(MeshFormat format) {
  switch (format) {
    case MeshFormat::kObj:
      return "obj";
    case MeshFormat::kPly:
      return "ply";
    case MeshFormat::kStl:
      return "stl";
    case MeshFormat::kOff:
      return "off";
    case MeshFormat::kCollada:
      return "dae";
    case MeshFormat::k3ds:
      return "3ds";
    case MeshFormat::kGltf:
      break;
  }
  return "";
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

Vec3 to_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

// The normals of STL belong to facets: taken for vertex normals they would shade every mesh flat.
bool has_vertex_normals(const aiMesh& mesh, MeshFormat format) {
  return mesh.HasNormals() && format != MeshFormat::kStl;
}

// Tags are whole numbers; what is none stays 0.
std::uint32_t tag_number(ai_real value) {
  return value > 0 && value < (1u << 24) ? static_cast<std::uint32_t>(std::lround(value)) : 0;
}

void append(ImportedMesh& out, const aiMesh& mesh, MeshFormat format, const std::string& subject) {
  const bool with_normals = has_vertex_normals(mesh, format);
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    std::array<RawMesh::Corner, 3> triangle;
    TriangleSource source;
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned index = face.mIndices[i];
      if (index >= mesh.mNumVertices) {
        throw Failure(subject, "face index out of range (" + std::to_string(index) + " of " +
                                   std::to_string(mesh.mNumVertices) + " vertices)");
      }
      triangle[i].position = to_vec3(mesh.mVertices[index]);
      if (!finite(triangle[i].position)) throw Failure(subject, "a coordinate is not a finite number");
      if (mesh.HasTextureCoords(0)) {
        source.face = tag_number(mesh.mTextureCoords[0][index].x);
        source.vertices[i] = tag_number(mesh.mTextureCoords[0][index].y);
      }
      if (!with_normals) continue;
      const Vec3 normal = to_vec3(mesh.mNormals[index]);
      if (finite(normal)) triangle[i].normal = normal;
    }
    out.triangles.push_back(triangle);
    if (mesh.HasTextureCoords(0)) out.sources.push_back(source);
  }
}

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

/// A mesh of a scene, moved by its node's transform. The library's v is up.
void append_to_scene(ImportedMesh& out, const aiMesh& mesh, const aiMatrix4x4& transform, std::uint32_t look,
                     const std::string& subject) {
  const std::size_t first = out.triangles.size();
  append(out, mesh, MeshFormat::kCollada, subject);
  aiMatrix3x3 of_normals(transform);
  const bool mirrors = of_normals.Determinant() < 0;
  of_normals.Inverse().Transpose();
  std::size_t triangle = first;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    std::array<RawMesh::Corner, 3>& corners = out.triangles[triangle++];
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned index = face.mIndices[i];
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
  }
  out.sources.resize(first);
  out.sources.resize(out.triangles.size(), TriangleSource{look, {}});
}

ImportedMesh import_scene(const aiScene& scene, const std::string& subject) {
  struct Visit {
    const aiNode* node;
    aiMatrix4x4 parent;
  };
  ImportedMesh out;
  nlohmann::json looks = nlohmann::json::array();
  std::vector<Visit> open{{scene.mRootNode, {}}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    if (visit.node == nullptr) continue;
    const aiMatrix4x4 transform = visit.parent * visit.node->mTransformation;
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[visit.node->mMeshes[i]];
      append_to_scene(out, mesh, transform, static_cast<std::uint32_t>(looks.size()), subject);
      looks.push_back(look_of(mesh, *visit.node, scene));
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      open.push_back({visit.node->mChildren[i - 1], transform});
    }
  }
  out.looks = looks.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return out;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace

ImportedMesh import_mesh(std::string_view screened, MeshFormat format, const std::string& subject) {
  Assimp::Importer importer;
  keep_only(importer, extension(format));
  const aiScene* scene =
      importer.ReadFileFromMemory(screened.data(), screened.size(), aiProcess_Triangulate, extension(format));
  if (scene == nullptr) throw Failure(subject, "cannot be read: " + one_line(importer.GetErrorString()));
  if (is_scene(format)) return import_scene(*scene, subject);
  ImportedMesh raw;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(raw, *scene->mMeshes[m], format, subject);
  return raw;
}

}  // namespace arcspan::tools
