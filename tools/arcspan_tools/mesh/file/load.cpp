// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/mesh/file/isolate.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/progress.hpp>

#include <algorithm>
#include <cctype>
#include <utility>

namespace arcspan::tools {
namespace {

/// A text file of kMaxTriangles triangles needs about a tenth of this.
constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;

RawMesh import_isolated(std::string_view screened, MeshFormat format, const std::string& subject) {
  Progress progress("reading " + printable(subject), 0);
  return run_isolated(
      subject, [&] { return import_mesh(screened, format, subject); },
      [&](std::size_t received) { progress.show(received); });
}

}  // namespace

std::optional<MeshFormat> mesh_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".stl") return MeshFormat::kStl;
  if (extension == ".off") return MeshFormat::kOff;
  return std::nullopt;
}

MeshData load_mesh_from_memory(std::string_view bytes, MeshFormat format, const std::string& subject) {
  ScreenedMesh file = screened(bytes, format, subject);
  MeshData mesh = weld(import_mesh(file.text, format, subject), subject);
  mesh.warnings = std::move(file.warnings);
  return mesh;
}

MeshData load_mesh(const std::string& name) {
  if (const std::optional<GeneratedMesh> wanted = parse_generated_mesh(name)) return generate(*wanted);
  if (output_kind(name, "") == "bin") return mesh_from_binary(read_whole_file(name, kMaxFileBytes), name);
  const std::optional<MeshFormat> format = mesh_format(name);
  if (!format) {
    throw Failure(name,
                  "not a mesh that can be read (.obj, .ply, .stl, .off, .bin, sphere:32x16, torus:48x24)");
  }
  ScreenedMesh file = screened(read_whole_file(name, kMaxFileBytes), *format, name);
  MeshData mesh = weld(import_isolated(file.text, *format, name), name);
  mesh.warnings = std::move(file.warnings);
  return mesh;
}

}  // namespace arcspan::tools
