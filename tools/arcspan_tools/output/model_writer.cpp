// SPDX-License-Identifier: MIT
#include <arcspan/model/model_binary.hpp>

#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/output/texture_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <bit>
#include <set>

namespace arcspan::tools {
namespace {

namespace layout = arcspan::model_binary;

void append(std::string& out, double value) { append_number(out, std::bit_cast<std::uint64_t>(value), 8); }

void append(std::string& out, const ChannelCoefficients& c) {
  for (const Coefficient channel : {c.r, c.g, c.b})
    append_number(out, static_cast<std::uint64_t>(channel.raw()), 2);
}

/// The bytes around the mesh and texture binaries.
std::size_t bytes_around(std::size_t parts, bool textured) {
  return layout::kHeaderBytes + parts * (textured ? layout::kTexturedPartBytes : layout::kPartBytes) +
         layout::kChecksumBytes;
}

std::uint16_t flags_of(const FileMaterial& material, bool textured) {
  const PartAlpha alpha = textured ? part_alpha(material) : PartAlpha::kOpaque;
  return static_cast<std::uint16_t>((material.two_sided ? layout::kTwoSided : 0) |
                                    (alpha == PartAlpha::kMasked ? layout::kMasked : 0) |
                                    (alpha == PartAlpha::kBlended ? layout::kBlended : 0));
}

/// A binary within the file.
struct Place {
  std::size_t begin = 0;
  std::size_t bytes = 0;
};

/// An entry as version 1 has it.
void append_entry(std::string& out, const PartLook& look, std::string name, const Place& mesh,
                  bool textured) {
  const Material material = material_of(look);
  append_number(out, mesh.begin, 4);
  append_number(out, mesh.bytes, 4);
  for (const ChannelCoefficients& c : {material.ambient, material.diffuse, material.specular}) append(out, c);
  append_number(out, static_cast<std::uint64_t>(material.shininess), 2);
  append_number(out, flags_of(look.material, textured), 2);
  append_number(out, 0, 2);
  name.resize(layout::kNameBytes - 1);
  out += name + '\0';
}

std::string name_of(const PartLook& look, std::size_t number) {
  if (!look.names.empty()) return look.names.back();
  return look.material.name.empty() ? "part " + std::to_string(number) : look.material.name;
}

}  // namespace

Material material_of(const PartLook& look) { return to_fixed(with_material({}, look.material, {})); }

PartAlpha part_alpha(const FileMaterial& material) {
  if (material.texture == nullptr || material.alpha_mode == AlphaMode::kOpaque) return PartAlpha::kOpaque;
  return material.alpha_mode == AlphaMode::kMask ? PartAlpha::kMasked : PartAlpha::kBlended;
}

bool is_plain_mesh(const FixedModel& model) {
  FileMaterial named;
  named.name = model.looks[0].material.name;
  named.sampler = model.looks[0].material.sampler;  // says nothing without a texture
  return model.meshes.size() == 1 && model.looks[0].material == named;
}

std::vector<std::string> part_names(const FixedModel& model) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < model.looks.size(); ++i) {
    const PartLook& look = model.looks[i];
    std::string name = name_of(look, i + 1);
    if (!taken.insert(name).second) {
      if (!look.material.name.empty() && look.material.name != name) name += " " + look.material.name;
      const std::string base = name;
      for (int n = 2; !taken.insert(name).second; ++n) name = base + " " + std::to_string(n);
    }
    names.push_back(name);
  }
  return names;
}

std::size_t model_bytes(CompiledOutput output, const FixedModel& model, bool planes,
                        const ModelTextures& textures) {
  std::size_t sum = 0;
  for (const FixedMesh& mesh : model.meshes) {
    sum += mesh_bytes(output, mesh.positions.size(), mesh.indices.size() / 3, planes,
                      !mesh.texture_points.empty(), !mesh.colours.empty());
  }
  if (is_plain_mesh(model)) return sum;
  const std::size_t parts = model.meshes.size();
  if (output == CompiledOutput::kHeader) return sum + parts * sizeof(Material) + textures.bytes();
  for (const MadeTexture& texture : textures.textures) {
    sum += texture_binary::bytes(texture.format.layout, texture.size);
  }
  return sum + bytes_around(parts, !textures.textures.empty());
}

std::vector<ByteShare> byte_shares(CompiledOutput output, const FixedModel& model,
                                   const ModelTextures& textures) {
  std::size_t vertices = 0;
  std::size_t indices = 0;
  std::size_t planes = 0;
  std::size_t points = 0;
  std::size_t colours = 0;
  for (const FixedMesh& mesh : model.meshes) {
    vertices += mesh.positions.size();
    indices += mesh.indices.size() * (fits_indices8(mesh.positions.size()) ? 1 : 2);
    planes += mesh.planes.size();
    points += mesh.texture_points.size();
    colours += mesh.colours.size();
  }
  std::vector<ByteShare> shares = {{"positions", vertices * sizeof(ObjectPosition)},
                                   {"normals", vertices * sizeof(PackedNormal)},
                                   {"indices", indices},
                                   {"planes", planes * sizeof(FacePlane)},
                                   {"texture points", points * sizeof(TexturePoint)},
                                   {"vertex colours", colours * sizeof(Rgb8)},
                                   {"textures", textures.bytes()}};
  std::size_t sum = 0;
  for (const ByteShare& share : shares) sum += share.bytes;
  shares.push_back({"materials and headers", model_bytes(output, model, planes != 0, textures) - sum});
  return shares;
}

namespace {

/// The binaries that follow the entries, and where they are.
struct Binaries {
  std::string bytes{};
  std::vector<Place> meshes{};    ///< of the parts
  std::vector<Place> textures{};  ///< of ModelTextures
};

Binaries binaries_of(const FixedModel& model, const ModelTextures& textures, std::size_t begin) {
  Binaries all;
  const auto add = [&all, begin](const std::string& binary, std::vector<Place>& places) {
    places.push_back({begin + all.bytes.size(), binary.size()});
    all.bytes += binary;
  };
  for (const FixedMesh& mesh : model.meshes) add(mesh_binary_file(mesh, figures_of(mesh)), all.meshes);
  for (const MadeTexture& texture : textures.textures) add(texture_binary_file(texture), all.textures);
  return all;
}

}  // namespace

std::string model_binary_file(const FixedModel& model, const ModelTextures& textures) {
  if (is_plain_mesh(model)) return mesh_binary_file(model.meshes[0], figures_of(model.meshes[0]));
  constexpr std::size_t kMostParts = 0xFFFF;
  if (model.meshes.size() > kMostParts) throw Failure("model", "more than 65535 parts");
  const std::vector<std::string> names = part_names(model);
  const bool textured = !textures.textures.empty();
  const std::size_t around = bytes_around(names.size(), textured);
  const Binaries binaries = binaries_of(model, textures, around);
  std::size_t most = 0;
  for (const FixedMesh& mesh : model.meshes) most = std::max(most, mesh.positions.size());
  std::string out;
  append_number(out, layout::kMagic, 4);
  append_number(out, textured ? layout::kVersionOfTextures : layout::kVersion, 2);
  append_number(out, names.size(), 2);
  append_number(out, around + binaries.bytes.size(), 4);
  append_number(out, most, 4);
  const FixedMesh& first = model.meshes[0];
  for (const double value : {first.unit, first.centre.x, first.centre.y, first.centre.z}) append(out, value);
  for (std::size_t i = 0; i < names.size(); ++i) {
    append_entry(out, model.looks[i], names[i], binaries.meshes[i], textured);
    if (!textured) continue;
    const std::optional<std::size_t> number = textures.of_part[i];
    const Place place = number ? binaries.textures[*number] : Place{};
    append_number(out, place.begin, 4);
    append_number(out, place.bytes, 4);
  }
  append_checksum(out);
  return out + binaries.bytes;
}

}  // namespace arcspan::tools
