// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <charconv>
#include <initializer_list>

namespace arcspan::tools {
namespace {

constexpr std::size_t kColumns = 108;

/// An array's elements, as many in a line as fit.
class ArrayText {
 public:
  void add(const std::string& element) {
    if (column_ + element.size() + 2 > kColumns) {
      text_ += "\n   ";
      column_ = 3;
    }
    text_ += " " + element + ",";
    column_ += element.size() + 2;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t column_ = kColumns;
};

std::string braced(std::initializer_list<int> values) {
  std::string text = "{";
  for (const int value : values) text += (text.size() > 1 ? ", " : "") + std::to_string(value);
  return text + "}";
}

std::string triple(const ObjectPosition& p) { return braced({p.x, p.y, p.z}); }

std::string array(const std::string& type, const std::string& name, const ArrayText& rows) {
  return "inline constexpr " + type + " " + name + "[] = {" + rows.text() + "\n};\n\n";
}

std::string plane_arrays(const FixedMesh& mesh) {
  ArrayText planes;
  for (const FacePlane& p : mesh.planes) planes.add(braced({p.x, p.y, p.z, p.offset}));
  const PlaneScale& scale = mesh.plane_scale;
  return array("arcspan::FacePlane", "kPlanes", planes) + "inline constexpr arcspan::PlaneScale kPlaneScale" +
         braced({scale.normal_bits, scale.offset_bits, scale.radius}) + ";\n\n";
}

// Enough digits that the same number is read back; the shortest such text.
std::string number(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

// A comment must not end in a backslash, nor hold a line's end.
std::string harmless(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = '?';
  }
  return text;
}

std::string comment(const FixedMesh& mesh, const MeshFigures& figures, const std::string& origin) {
  const std::size_t vertices = mesh.positions.size();
  const std::size_t triangles = mesh.indices.size() / 3;
  std::string text = "// Made by `arcspan mesh` from " + harmless(origin) + ".\n//\n";
  text += "// " + std::to_string(vertices) + " vertices, " + std::to_string(triangles) + " triangles, " +
          std::to_string(mesh_bytes(MeshOutput::kHeader, vertices, triangles, !mesh.planes.empty())) +
          " bytes. Positions " + triple(figures.bounds.low) + " ... " + triple(figures.bounds.high) + ".\n";
  text += "// A step of a position is " + number(mesh.unit) +
          " of the model's units; the origin is its point (" + number(mesh.centre.x) + ", " +
          number(mesh.centre.y) + ", " + number(mesh.centre.z) + ").\n";
  return text;
}

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

std::string mesh_header(const FixedMesh& mesh, const MeshFigures& figures, const std::string& name,
                        const std::string& origin) {
  ArrayText positions;
  ArrayText normals;
  ArrayText indices;
  for (const ObjectPosition& p : mesh.positions) positions.add(triple(p));
  for (const PackedNormal& n : mesh.normals) normals.add(braced({n.u, n.v}));
  for (const std::uint16_t index : mesh.indices) indices.add(std::to_string(index));
  const bool planes = !mesh.planes.empty();
  const std::string index_type = fits_indices8(mesh.positions.size()) ? "std::uint8_t" : "std::uint16_t";
  return comment(mesh, figures, origin) +
         "#pragma once\n\n#include <arcspan/mesh/mesh_view.hpp>\n\n#include <cstdint>\n#include <span>\n\n"
         "namespace " +
         name + " {\n\n" + array("arcspan::ObjectPosition", "kPositions", positions) +
         array("arcspan::PackedNormal", "kNormals", normals) + array(index_type, "kIndices", indices) +
         (planes ? plane_arrays(mesh) : "") +
         "/// A view of the mesh; kOk unless the arrays were edited.\n"
         "inline arcspan::Status make_view(arcspan::MeshView& view) {\n" +
         (planes ? "  const arcspan::Status status =\n"
                   "      arcspan::MeshView::make(kPositions, kNormals, std::span(kIndices), view);\n"
                   "  return ok(status) ? view.attach(kPlanes, kPlaneScale) : status;\n"
                 : "  return arcspan::MeshView::make(kPositions, kNormals, std::span(kIndices), view);\n") +
         "}\n\n}  // namespace " + name + "\n";
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
