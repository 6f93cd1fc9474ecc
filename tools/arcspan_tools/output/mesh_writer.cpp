// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <initializer_list>

namespace arcspan::tools {
namespace {

void put_i16(std::string& out, std::initializer_list<std::int16_t> values) {
  for (const std::int16_t value : values) append_number(out, static_cast<std::uint16_t>(value), 2);
}

void put_planes(std::string& out, const FixedMesh& mesh) {
  const auto byte = [&out](std::int8_t value) { append_number(out, static_cast<std::uint8_t>(value), 1); };
  byte(mesh.plane_scale.normal_bits);
  append_number(out, mesh.plane_scale.offset_bits, 1);
  append_number(out, mesh.plane_scale.radius, 2);
  for (const FacePlane& p : mesh.planes) {
    for (const std::int8_t value : {p.x, p.y, p.z, p.offset}) byte(value);
  }
}

void put_texture_points(std::string& out, const FixedMesh& mesh) {
  append_number(out, mesh.texture_scale.fraction_bits, 4);
  for (const TexturePoint& p : mesh.texture_points) put_i16(out, {p.u, p.v});
}

}  // namespace

CompiledOutput compiled_output(const std::filesystem::path& path, const std::string& kind) {
  const std::string extension = output_kind(path, "hpp");
  if (extension == "hpp" || extension == "h") return CompiledOutput::kHeader;
  if (extension == "bin") return CompiledOutput::kBinary;
  throw Failure(path.string(), "a compiled " + kind + "'s name must end in .hpp, .h or .bin");
}

CompiledOutput compiled_mesh_output(const std::filesystem::path& path, bool for_c) {
  if (!for_c) return compiled_output(path, "mesh");
  const std::string extension = output_kind(path, "cpp");
  if (extension == "cpp") return CompiledOutput::kHeader;
  if (extension == "h") return CompiledOutput::kBinary;
  throw Failure(path.string(),
                "the name of a model for C must end in .cpp, a C++ source, or in .h, a binary");
}

std::size_t mesh_bytes(CompiledOutput output, std::size_t vertices, std::size_t triangles, bool planes,
                       bool texture_points, bool colours) {
  if (output == CompiledOutput::kHeader) {
    return array_bytes(vertices, triangles) +
           (planes ? sizeof(PlaneScale) + triangles * sizeof(FacePlane) : 0) +
           (texture_points ? sizeof(TextureScale) + vertices * sizeof(TexturePoint) : 0) +
           (colours ? vertices * sizeof(Rgb8) : 0);
  }
  return mesh_binary::bytes(vertices, triangles, fits_indices8(vertices), planes, texture_points, colours);
}

namespace {

/// A mesh binary, of which `checksum` bytes are still to be appended.
std::string mesh_before_checksum(const FixedMesh& mesh, const MeshFigures& figures, std::size_t checksum) {
  const std::size_t vertices = mesh.positions.size();
  const std::size_t triangles = mesh.indices.size() / 3;
  const bool indices8 = fits_indices8(vertices);
  const bool planes = !mesh.planes.empty();
  const bool points = !mesh.texture_points.empty();
  const bool colours = !mesh.colours.empty();
  const std::size_t size = mesh_binary::bytes(vertices, triangles, indices8, planes, points, colours) -
                           mesh_binary::kChecksumBytes;
  std::string out;
  append_number(out, mesh_binary::kMagic, 4);
  append_number(out,
                colours  ? mesh_binary::kVersionOfColours
                : points ? mesh_binary::kVersionOfTexturePoints
                : planes ? mesh_binary::kVersionOfPlanes
                         : mesh_binary::kVersion,
                2);
  append_number(out,
                (indices8 ? mesh_binary::kIndices8 : 0u) | (planes ? mesh_binary::kPlanes : 0u) |
                    (points ? mesh_binary::kTexturePoints : 0u) | (colours ? mesh_binary::kColours : 0u),
                2);
  append_number(out, static_cast<std::uint32_t>(size + checksum), 4);
  append_number(out, static_cast<std::uint32_t>(vertices), 4);
  append_number(out, static_cast<std::uint32_t>(triangles), 4);
  for (const ObjectPosition& p : {figures.bounds.low, figures.bounds.high}) put_i16(out, {p.x, p.y, p.z});
  for (const ObjectPosition& p : mesh.positions) put_i16(out, {p.x, p.y, p.z});
  for (const PackedNormal& n : mesh.normals) put_i16(out, {n.u, n.v});
  for (const std::uint16_t index : mesh.indices) append_number(out, index, indices8 ? 1 : 2);
  out.resize(mesh_binary::bytes(vertices, triangles, indices8) - mesh_binary::kChecksumBytes, '\0');
  if (planes) put_planes(out, mesh);
  if (points) put_texture_points(out, mesh);
  for (const Rgb8& c : mesh.colours) {
    for (const std::uint8_t channel : {c.r, c.g, c.b}) append_number(out, channel, 1);
  }
  out.resize(size, '\0');
  return out;
}

}  // namespace

std::string mesh_chunk(const FixedMesh& mesh, const MeshFigures& figures) {
  return mesh_before_checksum(mesh, figures, 0);
}

std::string mesh_binary_file(const FixedMesh& mesh, const MeshFigures& figures) {
  std::string out = mesh_before_checksum(mesh, figures, mesh_binary::kChecksumBytes);
  append_checksum(out);
  return out;
}

}  // namespace arcspan::tools
