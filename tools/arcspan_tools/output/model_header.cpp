// SPDX-License-Identifier: MIT
#include <arcspan/mesh/bounding_sphere.hpp>

#include <arcspan_tools/output/array_text.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/output/texture_writer.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <initializer_list>
#include <set>

namespace arcspan::tools {
namespace {

std::string braced(std::initializer_list<int> values) {
  std::string text = "{";
  for (const int value : values) text += (text.size() > 1 ? ", " : "") + std::to_string(value);
  return text + "}";
}

std::string braced_position(const ObjectPosition& p) { return braced({p.x, p.y, p.z}); }

std::string plane_arrays(const FixedMesh& mesh) {
  ArrayText planes;
  for (const FacePlane& p : mesh.planes) planes.add(braced({p.x, p.y, p.z, p.offset}));
  const PlaneScale& scale = mesh.plane_scale;
  return planes.array("arcspan::FacePlane", "kPlanes") + "inline constexpr arcspan::PlaneScale kPlaneScale" +
         braced({scale.normal_bits, scale.offset_bits, scale.radius}) + ";\n\n";
}

std::string texture_point_arrays(const FixedMesh& mesh) {
  ArrayText points;
  for (const TexturePoint& p : mesh.texture_points) points.add(braced({p.u, p.v}));
  return points.array("arcspan::TexturePoint", "kTexturePoints") +
         "inline constexpr arcspan::TextureScale kTextureScale" + braced({mesh.texture_scale.fraction_bits}) +
         ";\n\n";
}

std::string colour_array(const FixedMesh& mesh) {
  ArrayText colours;
  for (const Rgb8& c : mesh.colours) colours.add(braced({c.r, c.g, c.b}));
  return colours.array("arcspan::Rgb8", "kColours");
}

std::string neighbour_array(const FixedMesh& mesh) {
  ArrayText bytes;
  for (const std::uint8_t byte : mesh.neighbours) bytes.add(std::to_string(byte));
  return bytes.array("std::uint8_t", "kNeighbours");
}

/// The function that makes the view of the neighbours.
constexpr const char* kMakeNeighbours =
    "/// The neighbours of the triangles of make_view(), for outlines; kOk unless the arrays were edited.\n"
    "inline arcspan::Status make_neighbours(const arcspan::MeshView& view,\n"
    "                                       arcspan::MeshNeighbours& neighbours) {\n"
    "  return arcspan::MeshNeighbours::make(view, kNeighbours, neighbours);\n}\n\n";

bool has_neighbours(const FixedModel& model) { return !model.meshes[0].neighbours.empty(); }

// Enough digits that the same number is read back; the shortest such text.
std::string shortest_number(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string comment(const FixedModel& model, const std::string& origin, const ModelTextures& textures,
                    CompiledOutput output = CompiledOutput::kHeader) {
  const MeshFigures figures = figures_of(model);
  const bool planes = !model.meshes[0].planes.empty();
  std::string text = "// Made by `arcspan mesh` from " + harmless(origin) + ".\n//\n";
  text += "// " + std::to_string(model.vertex_count()) + " vertices, " +
          std::to_string(model.triangle_count()) + " triangles, " +
          std::to_string(model_bytes(output, model, planes, textures)) + " bytes. Positions " +
          braced_position(figures.bounds.low) + " ... " + braced_position(figures.bounds.high) + ".\n";
  if (model.meshes.size() > 1) text += "// " + std::to_string(model.meshes.size()) + " parts.\n";
  return text;
}

std::string unit_and_origin(const FixedMesh& mesh) {
  return "/// The length of an object unit in the model's units, and the model's point at the object's "
         "origin.\n"
         "inline constexpr double kUnit = " +
         shortest_number(mesh.unit) + ";\ninline constexpr double kOrigin[] = {" +
         shortest_number(mesh.centre.x) + ", " + shortest_number(mesh.centre.y) + ", " +
         shortest_number(mesh.centre.z) + "};\n\n";
}

/// The body of make_view().
std::string view_text(bool planes, bool points, bool colours) {
  const std::string make = "arcspan::MeshView::make(kPositions, kNormals, std::span(kIndices), view);\n";
  if (!planes && !points && !colours) return "  return " + make;
  std::string text = "  arcspan::Status status =\n      " + make;
  if (planes) text += "  if (ok(status)) status = view.attach(kPlanes, kPlaneScale);\n";
  if (points) text += "  if (ok(status)) status = view.attach(kTexturePoints, kTextureScale);\n";
  if (colours) text += "  if (ok(status)) status = view.attach(kColours);\n";
  return text + "  return status;\n";
}

/// The arrays and make_view().
std::string mesh_text(const FixedMesh& mesh) {
  ArrayText positions;
  ArrayText normals;
  ArrayText indices;
  for (const ObjectPosition& p : mesh.positions) positions.add(braced_position(p));
  for (const PackedNormal& n : mesh.normals) normals.add(braced({n.u, n.v}));
  for (const std::uint16_t index : mesh.indices) indices.add(std::to_string(index));
  const bool planes = !mesh.planes.empty();
  const bool points = !mesh.texture_points.empty();
  const bool colours = !mesh.colours.empty();
  const bool neighbours = !mesh.neighbours.empty();
  const std::string index_type = fits_indices8(mesh.positions.size()) ? "std::uint8_t" : "std::uint16_t";
  return positions.array("arcspan::ObjectPosition", "kPositions") +
         normals.array("arcspan::PackedNormal", "kNormals") + indices.array(index_type, "kIndices") +
         (planes ? plane_arrays(mesh) : "") + (points ? texture_point_arrays(mesh) : "") +
         (colours ? colour_array(mesh) : "") + (neighbours ? neighbour_array(mesh) : "") +
         "/// A view of the mesh; kOk unless the arrays were edited.\n"
         "inline arcspan::Status make_view(arcspan::MeshView& view) {\n" +
         view_text(planes, points, colours) + "}\n\n" + (neighbours ? kMakeNeighbours : "");
}

std::string braced_coefficients(const ChannelCoefficients& c) {
  std::string text;
  for (const Coefficient channel : {c.r, c.g, c.b}) {
    text += (text.empty() ? "{" : ", ") + std::string("arcspan::Coefficient::from_raw(") +
            std::to_string(channel.raw()) + ")";
  }
  return text + "}";
}

/// Coefficients are in 32768ths.
std::string material_text(const PartLook& look) {
  const Material material = material_of(look);
  return "inline constexpr arcspan::Material kMaterial = {\n    " + braced_coefficients(material.ambient) +
         ",\n    " + braced_coefficients(material.diffuse) + ",\n    " +
         braced_coefficients(material.specular) + ",\n    " + std::to_string(material.shininess) +
         "};\ninline constexpr bool kTwoSided = " + (look.material.two_sided ? "true" : "false") + ";\n\n";
}

std::string texture_namespace(std::size_t number) { return "texture_" + std::to_string(number + 1); }

/// Namespaces of the parts, no two alike.
std::vector<std::string> namespaces_of(const FixedModel& model, std::size_t textures) {
  std::vector<std::string> names;
  std::set<std::string> taken{"Part", "kParts", "kUnit", "kOrigin", "kMostVertices"};
  for (std::size_t i = 0; i < textures; ++i) taken.insert(texture_namespace(i));
  for (const std::string& wanted : part_names(model)) {
    std::string name = identifier(wanted);
    for (int i = 2; !taken.insert(name).second; ++i) name = identifier(wanted) + "_" + std::to_string(i);
    names.push_back(name);
  }
  return names;
}

/// The textures of several parts, each in a namespace of its own.
std::string textures_text(const ModelTextures& textures) {
  std::string text;
  for (std::size_t i = 0; i < textures.textures.size(); ++i) {
    const std::string name = "namespace " + texture_namespace(i);
    text += name + " {\n\n";
    text += texture_arrays(textures.textures[i]);
    text += "}  // " + name + "\n\n";
  }
  return text;
}

std::string alpha_text(PartAlpha alpha) {
  return std::string("arcspan::PartAlpha::") + (alpha == PartAlpha::kMasked    ? "kMasked"
                                                : alpha == PartAlpha::kBlended ? "kBlended"
                                                                               : "kOpaque");
}

/// The members of the list of parts that textures add for part `i`.
std::string texture_members(const FixedModel& model, const ModelTextures& textures, std::size_t i) {
  if (textures.textures.empty()) return {};
  const std::optional<std::size_t> number = textures.of_part[i];
  return ", " + (number ? "&" + texture_namespace(*number) + "::kTexture" : "nullptr") + ", " +
         alpha_text(part_alpha(model.looks[i].material));
}

std::string parts_text(const FixedModel& model, const ModelTextures& textures) {
  const std::vector<std::string> names = namespaces_of(model, textures.textures.size());
  const std::vector<std::string> titles = part_names(model);
  std::string text = textures_text(textures);
  std::string list;
  std::size_t most = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "/// " + harmless(titles[i]) + "\nnamespace " + names[i] + " {\n\n" + mesh_text(model.meshes[i]) +
            material_text(model.looks[i]) + "}  // namespace " + names[i] + "\n\n";
    list += "    {" + names[i] + "::make_view, &" + names[i] + "::kMaterial, " + names[i] + "::kTwoSided" +
            texture_members(model, textures, i) +
            (has_neighbours(model) ? ", " + names[i] + "::make_neighbours" : "") + "},\n";
    most = std::max(most, model.meshes[i].positions.size());
  }
  return text +
         "/// A part of the model. All have the same unit and origin, and are drawn by the same transform.\n"
         "struct Part {\n"
         "  arcspan::Status (*make_view)(arcspan::MeshView& view);\n"
         "  const arcspan::Material* material;\n"
         "  bool two_sided;\n" +
         (textures.textures.empty()
              ? ""
              : "  const arcspan::Texture<" + type_of(textures.textures[0].format) +
                    ">* texture;  ///< null if it has none\n  arcspan::PartAlpha alpha;\n") +
         (has_neighbours(model)
              ? "  arcspan::Status (*make_neighbours)(const arcspan::MeshView& view,\n"
                "                                     arcspan::MeshNeighbours& neighbours);\n"
              : "") +
         "};\n"
         "inline constexpr Part kParts[] = {\n" +
         list +
         "};\n\n"
         "/// Vertices of the largest part, which a vertex cache has to hold.\n"
         "inline constexpr std::size_t kMostVertices = " +
         std::to_string(most) + ";\n\n";
}

std::string includes(const FixedModel& model, const ModelTextures& textures) {
  const bool single = model.meshes.size() == 1;
  std::string text;
  if (!is_plain_mesh(model)) text += "#include <arcspan/lighting/material.hpp>\n";
  if (has_neighbours(model)) text += "#include <arcspan/mesh/mesh_neighbours.hpp>\n";
  text += "#include <arcspan/mesh/mesh_view.hpp>\n";
  if (!textures.textures.empty()) {
    text += "#include <arcspan/model/model_binary.hpp>\n#include <arcspan/texture/texture.hpp>\n";
  }
  return text + "\n" + (single ? "" : "#include <cstddef>\n") + "#include <cstdint>\n#include <span>\n\n";
}

/// A model of one part.
std::string single_text(const FixedModel& model, const ModelTextures& textures) {
  std::string text = mesh_text(model.meshes[0]);
  if (!is_plain_mesh(model)) text += material_text(model.looks[0]);
  if (textures.textures.empty()) return text;
  return text + texture_arrays(textures.textures[0]) +
         "inline constexpr arcspan::PartAlpha kAlpha = " + alpha_text(part_alpha(model.looks[0].material)) +
         ";\n\n";
}

/// The header of a model that moves: its binary.
std::string binary_header(const FixedModel& model, const std::string& name, const std::string& origin,
                          const ModelTextures& textures) {
  ArrayText bytes;
  for (const char byte : model_binary_file(model, textures))
    bytes.add(std::to_string(static_cast<unsigned char>(byte)));
  return comment(model, origin, textures) + "#pragma once\n\n#include <cstdint>\n\nnamespace " + name +
         " {\n\n/// A model binary with nodes, skins and clips, for "
         "arcspan::view_model_binary().\nalignas(4) " +
         bytes.array("std::uint8_t", "kModel") + "}  // namespace " + name + "\n";
}

std::string model_namespace(const FixedModel& model, const std::string& name, const ModelTextures& textures) {
  return "namespace " + name + " {\n\n" + unit_and_origin(model.meshes[0]) +
         (model.meshes.size() == 1 ? single_text(model, textures) : parts_text(model, textures)) +
         "}  // namespace " + name + "\n";
}

std::string braced_sphere(const FixedMesh& mesh) {
  const BoundingSphere sphere = bounding_sphere(mesh.view("the compiled mesh"));
  return "{" + braced_position(sphere.middle) + ", " + std::to_string(sphere.radius) + "}";
}

/// The value of a material that the compiler prepares: that of the part in the namespace `part`, and the
/// texture in the namespace `skin` of the format `texels`, unless that is void.
std::string prepared_material(const std::string& part, const std::string& texels, const std::string& skin,
                              bool is_plain) {
  const std::string made_of = is_plain
                                  ? "arcspan::plastic({255, 255, 255}), {arcspan::c::kModelLights}"
                                  : part + "kMaterial, {arcspan::c::kModelLights}, {" + part + "kTwoSided}";
  return "arcspan::PreparedMaterial<arcspan::c::ModelMethod<" + texels + ">::Type>::of(\n    " + made_of +
         ")" + (texels == "void" ? "" : ".with(" + skin + "kTexture)");
}

std::string in_steps(const std::string& material, std::int32_t steps) {
  return steps == 0 ? material : "arcspan::c::in_steps<" + std::to_string(steps) + ">(" + material + ")";
}

/// An entry of the list of parts.
std::string prepared_part(const std::string& part, const FixedMesh& mesh, const std::string& material) {
  return "    {" + part + "make_view, " + braced_sphere(mesh) + ", &" + material +
         (mesh.neighbours.empty() ? "" : ", " + part + "make_neighbours") + "},\n";
}

/// The prepared materials, and the list of parts of a model for the C interface. The arrays are in the
/// namespace `arrays`.
std::string prepared_text(const FixedModel& model, const std::string& arrays, const ModelTextures& textures,
                          std::int32_t toon_steps) {
  const bool single = model.meshes.size() == 1;
  const std::vector<std::string> names = namespaces_of(model, textures.textures.size());
  std::string text;
  std::string list;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const std::string part = arrays + "::" + (single ? "" : names[i] + "::");
    const std::string material = "kPrepared" + std::to_string(i + 1);
    std::optional<std::size_t> number;
    if (!textures.textures.empty()) number = textures.of_part[i];
    const std::string texels = number ? type_of(textures.textures[*number].format) : "void";
    const std::string skin = arrays + "::" + (single || !number ? "" : texture_namespace(*number) + "::");
    const std::string value = prepared_material(part, texels, skin, is_plain_mesh(model));
    text.append("\nconstexpr auto ").append(material).append(" = ");
    text.append(in_steps(value, toon_steps)).append(";\n");
    list.append(prepared_part(part, model.meshes[i], material));
  }
  return text + "\nconstexpr arcspan::c::ModelPart kPreparedParts[] = {\n" + list + "};\n";
}

/// Bytes as words that a little-endian machine reads as these bytes, so that C aligns them.
ArrayText word_array(const std::string& bytes) {
  ArrayText words;
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4 && i + k < bytes.size(); ++k)
      word |= std::uint32_t{static_cast<unsigned char>(bytes[i + k])} << (8 * k);
    char text[9];
    std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(word));
    words.add(std::string("0x") + text);
  }
  return words;
}

}  // namespace

std::string model_c_header(const FixedModel& model, const std::string& name, const std::string& origin,
                           const ModelTextures& textures) {
  const std::string guard = "ARCSPAN_MODEL_" + name;
  return comment(model, origin, textures, CompiledOutput::kBinary) + "#ifndef " + guard + "\n#define " +
         guard + "\n\n#include <stdint.h>\n\n/* A binary of sizeof " + name +
         " bytes, for arcspan_add_binary()" + (model.rig != nullptr ? " or arcspan_add_character()" : "") +
         ". */\nstatic const uint32_t " + name + word_array(model_binary_file(model, textures)).c_array() +
         "#endif\n";
}

std::string model_header(const FixedModel& model, const std::string& name, const std::string& origin,
                         const ModelTextures& textures) {
  if (model.rig != nullptr) return binary_header(model, name, origin, textures);
  return comment(model, origin, textures) + "#pragma once\n\n" + includes(model, textures) +
         model_namespace(model, name, textures);
}

std::string model_c_source(const FixedModel& model, const std::string& name, const std::string& origin,
                           const ModelTextures& textures, std::int32_t toon_steps) {
  const std::string arrays = name + "_arrays";
  return comment(model, origin, textures) + "//\n// In C: extern const arcspan_model " + name +
         ";\n// clang-format off\n#include <arcspan/lighting/colour_coefficients.hpp>\n#include "
         "<arcspan_c/model.hpp>\n" +
         includes(model, textures) + model_namespace(model, arrays, textures) + "\nnamespace {\n" +
         prepared_text(model, arrays, textures, toon_steps) +
         "\n}  // namespace\n\nextern \"C\" {\nextern const arcspan_model " + name +
         ";\n}\nconst arcspan_model " + name + " = {kPreparedParts, " + std::to_string(model.meshes.size()) +
         "};\n";
}

}  // namespace arcspan::tools
