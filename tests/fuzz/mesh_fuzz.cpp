// SPDX-License-Identifier: MIT
// Arbitrary bytes as a mesh file, through everything that `arcspan render` does before the pipeline: the
// check, the loader library, joining. The first byte picks the format. A Failure is a right answer; a crash,
// a sanitizer's report or a mesh that breaks its promises is not.
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace arcspan::tools;

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

void check(const MeshData& mesh) {
  require(!mesh.triangles.empty());
  require(mesh.positions.size() == mesh.normals.size() && mesh.positions.size() <= kMaxVertices);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) require(index < mesh.positions.size());
  }
  for (const Vec3& position : mesh.positions) require(finite(position));
  for (const Vec3& normal : mesh.normals) require(std::fabs(length(normal) - 1) < 1e-6);
}

void check(const Model& model) {
  require(!model.parts.empty() && model.triangle_count() <= kMaxTriangles);
  for (const ModelPart& part : model.parts) check(part.mesh);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  constexpr MeshFormat kFormats[] = {MeshFormat::kObj, MeshFormat::kPly,  MeshFormat::kStl,
                                     MeshFormat::kOff, MeshFormat::kGltf, MeshFormat::kGltf,
                                     MeshFormat::kObj, MeshFormat::kPly};
  const MeshFormat format = kFormats[data[0] & 7u];
  try {
    check(load_model_from_memory({reinterpret_cast<const char*>(data) + 1, size - 1}, format, "fuzz"));
  } catch (const Failure&) {
  }
  return 0;
}
