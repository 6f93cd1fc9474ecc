// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
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
  ImportedMesh raw;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(raw, *scene->mMeshes[m], format, subject);
  return raw;
}

}  // namespace arcspan::tools
