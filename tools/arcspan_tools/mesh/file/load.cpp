// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/file/read_mesh.hpp>
#include <arcspan_tools/mesh/file/scene_model.hpp>
#include <arcspan_tools/mesh/file/triangle_colours.hpp>
#include <arcspan_tools/mesh/gltf/read_gltf.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/isolate.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <algorithm>
#include <cctype>
#include <utility>

namespace arcspan::tools {
namespace {

/// `import` turns the bytes of a scene into triangles.
template <class Import>
RawModel read_raw(std::string_view bytes, MeshFormat format, const std::string& subject,
                  const SideFiles& files, const Import& import) {
  if (bytes.find_first_not_of(std::string_view(" \t\r\n\0", 5)) == std::string_view::npos) {
    throw Failure(subject, "empty file");
  }
  switch (format) {
    case MeshFormat::kObj:
      return read_obj(bytes, subject, files);
    case MeshFormat::kPly:
      return read_ply(bytes, subject);
    case MeshFormat::kStl:
      return read_stl(bytes, subject);
    case MeshFormat::kOff:
      return read_off(bytes, subject);
    case MeshFormat::kGltf:
      return read_gltf(bytes, subject, files);
    case MeshFormat::kCollada:
    case MeshFormat::kFbx:
    case MeshFormat::k3ds:
      break;
  }
  return scene_model(import(), subject, files);
}

RawModel load_raw(const std::string& name, MeshFormat format, VertexColours colours) {
  const std::string bytes = read_whole_file(name, kMostFileBytes);
  RawModel raw = read_raw(bytes, format, name, side_files_of(name), [&] {
    return run_isolated(name, bytes.size(), [&] { return import_scene(bytes, format, name); });
  });
  apply_colours(raw, colours);
  return raw;
}

MeshFormat require_format(const std::string& name) {
  if (const std::optional<MeshFormat> format = mesh_format(name)) return *format;
  throw Failure(
      name,
      "not a mesh that can be read (.obj, .ply, .stl, .off, .gltf, .glb, .dae, .zae, .fbx, .3ds, .bin, "
      "sphere:32x16, torus:48x24)");
}

/// The model of a name that stands for no model file of other programs.
std::optional<Model> own_model(const std::string& name,
                               TexturePointsOf points = TexturePointsOf::kTexturedParts) {
  if (const std::optional<GeneratedMesh> wanted = parse_generated_mesh(name)) {
    if (points == TexturePointsOf::kTexturedParts) return to_model(generate(*wanted));
    return weld_parts(generate_with_texture_points(*wanted), name, points);
  }
  if (output_kind(name, "") == "bin") return model_from_binary(read_whole_file(name, kMostFileBytes), name);
  return std::nullopt;
}

/// Replaces the colours of vertices, if a part has some, by means of triangles.
Model with_mean_colours(Model model, const std::string& subject) {
  const auto has_colours = [](const ModelPart& part) { return !part.mesh.colours.empty(); };
  if (std::none_of(model.parts.begin(), model.parts.end(), has_colours)) return model;
  RawModel raw = to_raw(model);
  for (std::array<RawMesh::Corner, 3>& corners : raw.mesh.triangles) {
    TriangleColour colour{corners[0].colour.has_value(), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rgb8 c = std::exchange(corners[i].colour, std::nullopt).value_or(Rgb8{});
      colour.corners[i] = Vec3{double(c.r), double(c.g), double(c.b)} * (1.0 / 255);
    }
    raw.colours.push_back(colour);
  }
  apply_colours(raw, VertexColours::kMean);
  return weld_parts(raw, subject);
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
  if (extension == ".gltf" || extension == ".glb") return MeshFormat::kGltf;
  if (extension == ".dae" || extension == ".zae") return MeshFormat::kCollada;
  if (extension == ".fbx") return MeshFormat::kFbx;
  if (extension == ".3ds") return MeshFormat::k3ds;
  return std::nullopt;
}

Model load_model_from_memory(std::string_view bytes, MeshFormat format, const std::string& subject) {
  RawModel raw =
      read_raw(bytes, format, subject, no_side_files(), [&] { return import_scene(bytes, format, subject); });
  apply_colours(raw, VertexColours::kMean);
  return weld_parts(raw, subject);
}

Model load_model_file(const std::string& name, TexturePointsOf points, VertexColours colours,
                      double crease_degrees) {
  if (std::optional<Model> model = own_model(name, points)) {
    const bool is_kept = colours == VertexColours::kKept || model->binary != nullptr;
    return is_kept ? std::move(*model) : with_mean_colours(std::move(*model), name);
  }
  RawModel raw = load_raw(name, require_format(name), colours);
  const bool creased = add_creased_normals(raw.mesh, crease_degrees);
  Model model = weld_parts(raw, name, points);
  if (creased) model.crease_degrees = crease_degrees;
  return model;
}

MeshData load_mesh(const std::string& name, double crease_degrees) {
  if (std::optional<Model> model = own_model(name)) {
    return model->parts.size() == 1 ? std::move(model->parts[0].mesh) : weld(to_raw(*model).mesh, name);
  }
  RawModel raw = load_raw(name, require_format(name), VertexColours::kMean);
  (void)add_creased_normals(raw.mesh, crease_degrees);
  return weld(raw.mesh, name);
}

}  // namespace arcspan::tools
