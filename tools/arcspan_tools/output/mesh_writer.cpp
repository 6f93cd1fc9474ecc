// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <initializer_list>

namespace arcspan::tools {
namespace {

void put(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xFFu));
}

void put_i16(std::string& out, std::initializer_list<std::int16_t> values) {
  for (const std::int16_t value : values) put(out, static_cast<std::uint16_t>(value), 2);
}

void put_planes(std::string& out, const FixedMesh& mesh) {
  const auto byte = [&out](std::int8_t value) { put(out, static_cast<std::uint8_t>(value), 1); };
  byte(mesh.plane_scale.normal_bits);
  put(out, mesh.plane_scale.offset_bits, 1);
  put(out, mesh.plane_scale.radius, 2);
  for (const FacePlane& p : mesh.planes) {
    for (const std::int8_t value : {p.x, p.y, p.z, p.offset}) byte(value);
  }
}

}  // namespace

MeshOutput mesh_output(const std::filesystem::path& path) {
  const std::string kind = output_kind(path, "hpp");
  if (kind == "hpp" || kind == "h") return MeshOutput::kHeader;
  if (kind == "bin") return MeshOutput::kBinary;
  throw Failure(path.string(), "a compiled mesh's name must end in .hpp, .h or .bin");
}

std::size_t mesh_bytes(MeshOutput output, std::size_t vertices, std::size_t triangles, bool planes) {
  if (output == MeshOutput::kHeader) {
    return array_bytes(vertices, triangles) +
           (planes ? sizeof(PlaneScale) + triangles * sizeof(FacePlane) : 0);
  }
  return mesh_binary::bytes(vertices, triangles, fits_indices8(vertices), planes);
}

std::string mesh_binary_file(const FixedMesh& mesh, const MeshFigures& figures) {
  const std::size_t vertices = mesh.positions.size();
  const std::size_t triangles = mesh.indices.size() / 3;
  const bool indices8 = fits_indices8(vertices);
  const bool planes = !mesh.planes.empty();
  const std::size_t size = mesh_binary::bytes(vertices, triangles, indices8, planes);
  std::string out;
  put(out, mesh_binary::kMagic, 4);
  put(out, planes ? mesh_binary::kVersionOfPlanes : mesh_binary::kVersion, 2);
  put(out, (indices8 ? mesh_binary::kIndices8 : 0u) | (planes ? mesh_binary::kPlanes : 0u), 2);
  put(out, static_cast<std::uint32_t>(size), 4);
  put(out, static_cast<std::uint32_t>(vertices), 4);
  put(out, static_cast<std::uint32_t>(triangles), 4);
  for (const ObjectPosition& p : {figures.bounds.low, figures.bounds.high}) put_i16(out, {p.x, p.y, p.z});
  for (const ObjectPosition& p : mesh.positions) put_i16(out, {p.x, p.y, p.z});
  for (const PackedNormal& n : mesh.normals) put_i16(out, {n.u, n.v});
  for (const std::uint16_t index : mesh.indices) put(out, index, indices8 ? 1 : 2);
  out.resize(mesh_binary::bytes(vertices, triangles, indices8) - mesh_binary::kChecksumBytes, '\0');
  if (planes) put_planes(out, mesh);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(out.data());
  put(out, crc32({bytes, out.size()}), 4);
  return out;
}

}  // namespace arcspan::tools
