// SPDX-License-Identifier: MIT
#include <arcspan/animate/animation_binary.hpp>
#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/model/model_neighbours.hpp>

#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/mesh/plain/clip.hpp>
#include <arcspan_tools/output/animation_writer.hpp>
#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/output/chunk_writer.hpp>
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

/// The chunks and what is around them, of meshes, textures and neighbours of parts that take `payload` bytes
/// as chunks.
std::size_t container_bytes(std::size_t parts, std::size_t textures, std::size_t neighbours,
                            std::size_t payload) {
  const std::size_t chunks = 2 + parts + textures + neighbours;
  return chunk_list::kHeaderBytes + chunks * chunk_list::kEntryBytes + layout::kModelBytes +
         parts * layout::kPartBytes + payload + chunk_list::kChecksumBytes;
}

/// Whether a binary of the model is a mesh binary, which has no place for neighbours.
bool is_mesh_binary(const FixedModel& model) {
  return is_plain_mesh(model) && model.meshes[0].neighbours.empty();
}

/// The bytes of a chunk with what fills it up.
std::size_t filled_up(std::size_t bytes) {
  return (bytes + chunk_list::kAlignment - 1) / chunk_list::kAlignment * chunk_list::kAlignment;
}

std::vector<FileChunk> chunks_of(const FixedModel& model) {
  if (model.animation == nullptr) return {};
  return animation_chunks(*model.animation, "the model");
}

/// Bytes of a chunk in the container.
std::size_t bytes_in_file(const FileChunk& chunk) {
  return chunk_list::kEntryBytes + filled_up(chunk.bytes.size());
}

/// Names of the shares of chunks.
const char* share_of(std::uint32_t tag) {
  if (tag == animation_binary::kWeightsTag) return "weights";
  if (tag == animation_binary::kMorphTag) return "morph targets";
  if (tag == animation_binary::kBoundsTag) return "bounds";
  return tag == animation_binary::kClipTag ? "clips" : "nodes and joints";
}

void add_animation_shares(const FixedModel& model, std::vector<ByteShare>& shares) {
  const std::vector<FileChunk> chunks = chunks_of(model);
  for (const char* name : {"nodes and joints", "weights", "morph targets", "bounds", "clips"}) {
    ByteShare share{name, 0};
    for (const FileChunk& chunk : chunks)
      share.bytes += std::string_view(name) == share_of(chunk.tag) ? bytes_in_file(chunk) : 0;
    shares.push_back(share);
  }
}

std::string name_of(const PartLook& look, std::size_t number) {
  if (!look.names.empty()) return look.names.back();
  return look.material.name.empty() ? "part " + std::to_string(number) : look.material.name;
}

}  // namespace

Material material_of(const PartLook& look) {
  const FileMaterial& file = look.material;
  if (!file.colour && !file.ambient_colour && !file.specular && !file.shininess && !file.unlit &&
      file.emission == Vec3{} && file.texture == nullptr)
    return plastic({255, 255, 255});
  return to_fixed(with_material({.colour = {1, 1, 1}}, file, {}));
}

PartAlpha part_alpha(const FileMaterial& material) {
  if (material.texture == nullptr || material.alpha_mode == AlphaMode::kOpaque) return PartAlpha::kOpaque;
  return material.alpha_mode == AlphaMode::kMask ? PartAlpha::kMasked : PartAlpha::kBlended;
}

bool is_plain_mesh(const FixedModel& model) {
  FileMaterial named;
  named.name = model.looks[0].material.name;
  named.sampler = model.looks[0].material.sampler;  // says nothing without a texture
  return model.meshes.size() == 1 && model.rig == nullptr && model.looks[0].material == named;
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
  if (model.rig != nullptr) output = CompiledOutput::kBinary;  // a header holds the bytes of one
  std::size_t sum = 0;
  std::size_t neighbours = 0;  // parts that have them
  for (const FixedMesh& mesh : model.meshes) {
    sum += mesh_bytes(output, mesh.positions.size(), mesh.indices.size() / 3, planes,
                      !mesh.texture_points.empty(), !mesh.colours.empty());
    const std::size_t bytes = mesh.neighbours.size();
    sum += output == CompiledOutput::kHeader ? bytes : filled_up(bytes);
    neighbours += bytes != 0 ? 1 : 0;
  }
  const std::size_t parts = model.meshes.size();
  for (const FileChunk& chunk : chunks_of(model)) sum += bytes_in_file(chunk);
  if (output == CompiledOutput::kHeader)
    return is_plain_mesh(model) ? sum : sum + parts * sizeof(Material) + textures.bytes();
  if (is_mesh_binary(model)) return sum;
  sum -= parts * mesh_binary::kChecksumBytes;  // chunks have none
  for (const MadeTexture& texture : textures.textures) {
    sum += texture_binary::bytes(texture.format.layout, texture.size) - texture_binary::kChecksumBytes;
  }
  return container_bytes(parts, textures.textures.size(), neighbours, sum);
}

std::vector<ByteShare> byte_shares(CompiledOutput output, const FixedModel& model,
                                   const ModelTextures& textures) {
  std::size_t vertices = 0;
  std::size_t indices = 0;
  std::size_t planes = 0;
  std::size_t points = 0;
  std::size_t colours = 0;
  std::size_t neighbours = 0;
  for (const FixedMesh& mesh : model.meshes) {
    vertices += mesh.positions.size();
    indices += mesh.indices.size() * (fits_indices8(mesh.positions.size()) ? 1 : 2);
    planes += mesh.planes.size();
    points += mesh.texture_points.size();
    colours += mesh.colours.size();
    neighbours += mesh.neighbours.size();
  }
  std::vector<ByteShare> shares = {{"positions", vertices * sizeof(ObjectPosition)},
                                   {"normals", vertices * sizeof(PackedNormal)},
                                   {"indices", indices},
                                   {"planes", planes * sizeof(FacePlane)},
                                   {"texture points", points * sizeof(TexturePoint)},
                                   {"vertex colours", colours * sizeof(Rgb8)},
                                   {"neighbours", neighbours},
                                   {"textures", textures.bytes()}};
  if (model.animation != nullptr) add_animation_shares(model, shares);
  std::size_t sum = 0;
  for (const ByteShare& share : shares) sum += share.bytes;
  shares.push_back({"materials and headers", model_bytes(output, model, planes != 0, textures) - sum});
  return shares;
}

namespace {

void append(std::string& out, double value) { append_number(out, std::bit_cast<std::uint64_t>(value), 8); }

void append(std::string& out, const ChannelCoefficients& c) {
  for (const Coefficient channel : {c.r, c.g, c.b})
    append_number(out, static_cast<std::uint64_t>(channel.raw()), 2);
}

void append(std::string& out, const BoundingSphere& sphere) {
  for (const std::int16_t value : {sphere.middle.x, sphere.middle.y, sphere.middle.z})
    append_number(out, static_cast<std::uint16_t>(value), 2);
  append_number(out, sphere.radius, 2);
}

std::uint16_t flags_of(const FileMaterial& material) {
  const PartAlpha alpha = part_alpha(material);
  return static_cast<std::uint16_t>((material.two_sided ? layout::kTwoSided : 0) |
                                    (alpha == PartAlpha::kMasked ? layout::kMasked : 0) |
                                    (alpha == PartAlpha::kBlended ? layout::kBlended : 0));
}

std::string model_chunk(const FixedModel& model) {
  std::size_t most = 0;
  for (const FixedMesh& mesh : model.meshes) most = std::max(most, mesh.positions.size());
  std::string out;
  append_number(out, most, 4);
  append(out, sphere_of(model));
  const FixedMesh& first = model.meshes[0];
  for (const double value : {first.unit, first.centre.x, first.centre.y, first.centre.z}) append(out, value);
  return out;
}

std::string parts_chunk(const FixedModel& model, const ModelTextures& textures) {
  std::vector<std::string> names = shortened(part_names(model), layout::kNameBytes - 1);
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Material material = material_of(model.looks[i]);
    for (const ChannelCoefficients& c : {material.ambient, material.diffuse, material.specular})
      append(out, c);
    append_number(out, static_cast<std::uint64_t>(material.shininess), 2);
    append_number(out, flags_of(model.looks[i].material), 2);
    const bool textured = !textures.textures.empty() && textures.of_part[i].has_value();
    append_number(out, textured ? *textures.of_part[i] : layout::kNoTexture, 2);
    append(out, sphere_of(model.meshes[i]));
    names[i].resize(layout::kNameBytes);
    out += names[i];
  }
  return out;
}

/// Throws if the library refuses the animation of a model binary: no device is to be the first to find that.
void check_animation(const std::string& file) {
  StoredModel model;
  StoredAnimation animation;
  Status status = view_model_binary({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, model);
  if (ok(status)) status = view_animation(model, animation);
  if (!ok(status))
    throw Failure("the model", std::string("its animation cannot be stored: ") + to_string(status));
}

}  // namespace

std::string model_binary_file(const FixedModel& model, const ModelTextures& textures) {
  if (is_mesh_binary(model)) return mesh_binary_file(model.meshes[0], figures_of(model.meshes[0]));
  std::vector<FileChunk> chunks = chunks_of(model);
  for (std::size_t i = 0; i < model.meshes.size(); ++i)
    chunks.push_back({layout::kMeshTag, i, mesh_chunk(model.meshes[i], figures_of(model.meshes[i]))});
  chunks.push_back({layout::kModelTag, 0, model_chunk(model)});
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const std::vector<std::uint8_t>& bytes = model.meshes[i].neighbours;
    if (!bytes.empty())
      chunks.push_back({layout::kNeighboursTag, i, std::string(bytes.begin(), bytes.end())});
  }
  chunks.push_back({layout::kPartsTag, 0, parts_chunk(model, textures)});
  for (std::size_t i = 0; i < textures.textures.size(); ++i)
    chunks.push_back({layout::kTextureTag, i, texture_chunk(textures.textures[i])});
  std::stable_sort(chunks.begin(), chunks.end(),
                   [](const FileChunk& a, const FileChunk& b) { return a.tag < b.tag; });
  std::string file = chunk_file(chunks);
  if (model.animation != nullptr) check_animation(file);
  return file;
}

}  // namespace arcspan::tools
