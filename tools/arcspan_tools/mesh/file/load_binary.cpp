// SPDX-License-Identifier: MIT
#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/model/model_binary.hpp>

#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/fixed_point/unit_box.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

Vec3 to_vec3(const ObjectPosition& p) { return {double(p.x), double(p.y), double(p.z)}; }

Vec3 unit_vector(const Direction& d) {
  const auto component = [](DirectionComponent c) {
    return std::ldexp(c.raw(), -DirectionComponent::kFraction);
  };
  return normalised(Vec3{component(d.x), component(d.y), component(d.z)});
}

/// `textured`: with texture points.
MeshData to_data(const MeshView& view, bool textured) {
  MeshData mesh;
  for (std::size_t i = 0; i < view.vertex_count(); ++i) {
    mesh.positions.push_back(to_vec3(view.position(i)));
    mesh.normals.push_back(unit_vector(unpack_normal(view.normal(i))));
    if (!textured) continue;
    const TexturePoint p = view.texture_point(i);
    const int bits = -view.texture_scale().fraction_bits;
    mesh.texture_points.push_back({std::ldexp(p.u, bits), std::ldexp(p.v, bits)});
  }
  // Without colours all are white.
  for (std::size_t i = 0; i < view.vertex_count(); ++i) mesh.colours.push_back(view.colour(i));
  const auto is_white = [](Rgb8 c) { return c == Rgb8{255, 255, 255}; };
  if (std::all_of(mesh.colours.begin(), mesh.colours.end(), is_white)) mesh.colours.clear();
  for (std::size_t i = 0; i < view.triangle_count(); ++i) {
    const TriangleIndices t = view.triangle(i);
    mesh.triangles.push_back({t.a, t.b, t.c});
  }
  return mesh;
}

[[noreturn]] void refuse_damaged(const std::string& subject, const char* what, Status status) {
  throw Failure(subject, "the " + std::string(what) + " binary is damaged (" + to_string(status) + ")");
}

void require_triangles(std::size_t triangles, const std::string& subject) {
  if (triangles == 0) throw Failure(subject, "no faces");
  if (triangles <= kMaxTriangles) return;
  throw Failure(subject, "too many triangles (more than " + std::to_string(kMaxTriangles) + ", the limit)");
}

double double_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  double value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// A level of a texture, whose first texel is number `first`.
template <TexelFormat Texels>
void read_picture(const StoredTexture& stored, std::size_t first, RgbaImage& picture) {
  Texture<Texels> texture;
  if (!ok(view_texture(stored, texture))) return;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const std::uint16_t texel =
        Texels::stored(texture.at(0), texture.palette(), static_cast<std::uint32_t>(first + i));
    const unsigned c = Texels::ColourFormat::rgb565(texel);
    const unsigned green = (c >> 5) & 63u;
    picture.pixels[i] = {static_cast<std::uint8_t>(((c >> 8) & 0xF8u) | (c >> 13)),
                         static_cast<std::uint8_t>((green << 2) | (green >> 4)),
                         static_cast<std::uint8_t>(((c << 3) & 0xF8u) | ((c >> 2) & 7u)),
                         static_cast<std::uint8_t>((Texels::ColourFormat::alpha(texel) * 255u + 8) / 16)};
  }
}

template <TexelColour C>
void read_coloured_picture(const StoredTexture& stored, std::size_t first, RgbaImage& picture) {
  read_picture<DirectTexels<C>>(stored, first, picture);
  read_picture<Palette8Texels<C>>(stored, first, picture);
  read_picture<Palette4Texels<C>>(stored, first, picture);
}

RgbaImage level_of(const StoredTexture& stored, unsigned level) {
  const TextureSize& size = stored.size;
  RgbaImage picture((1 << size.width_bits) >> level, (1 << size.height_bits) >> level);
  const std::size_t first = size.texels(level);
  read_coloured_picture<OpaqueColour>(stored, first, picture);
  read_coloured_picture<Alpha1Colour>(stored, first, picture);
  read_coloured_picture<Alpha4Colour>(stored, first, picture);
  read_picture<GrayTexels>(stored, first, picture);
  return picture;
}

std::shared_ptr<const FileTexture> texture_of(const arcspan::ModelPart& part) {
  if (part.texture.texels.empty()) return nullptr;
  std::vector<RgbaImage> smaller;
  for (unsigned i = 1; i < part.texture.size.levels; ++i) smaller.push_back(level_of(part.texture, i));
  return std::make_shared<FileTexture>(FileTexture{part.name, level_of(part.texture, 0), std::move(smaller)});
}

/// The material of a part without the shares of light, which are the scene's.
FileMaterial file_material(const arcspan::ModelPart& part) {
  const auto share = [](const ChannelCoefficients& c, double whole) {
    const auto channel = [whole](Coefficient v) {
      return std::ldexp(v.raw(), -Coefficient::kFraction) / whole;
    };
    return Vec3{channel(c.r), channel(c.g), channel(c.b)};
  };
  const Surface scene;
  FileMaterial material;
  material.name = part.name;
  material.colour = share(part.material.diffuse, scene.diffuse.rgb.x);
  material.ambient_colour = share(part.material.ambient, scene.ambient.rgb.x);
  material.specular = share(part.material.specular, 1);
  material.shininess = part.material.shininess;
  material.two_sided = part.two_sided;
  material.sampler = part.texture.sampler;
  material.alpha_mode = part.alpha == PartAlpha::kMasked    ? AlphaMode::kMask
                        : part.alpha == PartAlpha::kBlended ? AlphaMode::kBlend
                                                            : AlphaMode::kOpaque;
  return material;
}

/// Of a binary whose version the library does not read, its own or that of a mesh or texture in it.
[[noreturn]] void refuse_version(std::span<const std::uint8_t> bytes, const std::string& subject) {
  const unsigned version = bytes.size() < 6 ? 0 : bytes[4] | (unsigned{bytes[5]} << 8u);
  if (version == chunk_list::kVersion) throw Failure(subject, "has a mesh or texture of an unknown version");
  throw Failure(subject, "a model binary of version " + std::to_string(version) +
                             ", not 3: write it again by arcspan mesh MODEL -o NAME.bin");
}

/// Whether joints, nodes or morph targets move a model. Throws a Failure if what does is damaged.
bool is_animated(const StoredModel& model, const std::string& subject) {
  StoredAnimation animation;
  const Status status = view_animation(model, animation);
  if (!ok(status))
    throw Failure(subject, std::string("its animation is damaged (") + to_string(status) + ")");
  bool morphs = false;
  for (std::size_t i = 0; i < model.part_count(); ++i)
    morphs = morphs || animation.morph(i).target_count() != 0;
  return morphs || animation.skin_count() != 0;
}

Model model_of_parts(std::span<const std::uint8_t> bytes, const std::string& subject) {
  StoredModel binary;
  const Status status = view_model_binary(bytes, binary);
  if (status == Status::kUnsupported) refuse_version(bytes, subject);
  if (!ok(status)) refuse_damaged(subject, "model", status);
  const std::span<const std::uint8_t> head = binary.chunks().find(model_binary::kModelTag);
  const double unit = double_at(head, model_binary::kUnitAt);
  const Vec3 origin{double_at(head, model_binary::kOriginAt), double_at(head, model_binary::kOriginAt + 8),
                    double_at(head, model_binary::kOriginAt + 16)};
  if (!(unit > 0 && unit < 1e30) || !finite(origin)) refuse_damaged(subject, "model", Status::kCorrupted);
  Model model;
  MovingBinary moving;
  std::map<const std::uint8_t*, std::shared_ptr<const FileTexture>> textures;  // parts may share one
  for (std::size_t i = 0; i < binary.part_count(); ++i) {
    const arcspan::ModelPart part = binary.part(i);
    MeshData mesh = to_data(part.mesh, !part.texture.texels.empty());
    if (mesh.triangles.empty()) continue;
    moving.part_numbers.push_back(i);
    for (Vec3& p : mesh.positions) p = origin + p * unit;
    FileMaterial material = file_material(part);
    std::shared_ptr<const FileTexture>& texture = textures[part.texture.texels.data()];
    if (texture == nullptr) texture = texture_of(part);
    material.texture = texture;
    model.parts.push_back({{{part.name}, std::move(material)}, std::move(mesh)});
  }
  require_triangles(model.triangle_count(), subject);
  if (is_animated(binary, subject)) {
    moving.bytes = bytes.size();
    moving.words.resize(bytes.size() / sizeof(std::uint32_t) + 1);
    std::memcpy(moving.words.data(), bytes.data(), bytes.size());
    model.binary = std::make_shared<MovingBinary>(std::move(moving));
    model.reach = box_of_units(origin, unit);
  }
  return model;
}

}  // namespace

Model model_from_binary(std::string_view bytes, const std::string& subject) {
  if (bytes.empty()) throw Failure(subject, "empty file");
  // Words, for the alignment that a string need not have.
  std::vector<std::uint32_t> words(bytes.size() / 4 + 1);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  const std::span binary(reinterpret_cast<const std::uint8_t*>(words.data()), bytes.size());
  if (bytes.starts_with("ARCP")) return model_of_parts(binary, subject);
  MeshView view;
  const Status status = view_mesh_binary(binary, view);
  if (status == Status::kUnsupported) throw Failure(subject, "not a mesh binary of version 1 to 4");
  if (!ok(status)) refuse_damaged(subject, "mesh", status);
  require_triangles(view.triangle_count(), subject);
  return to_model(to_data(view, false));
}

}  // namespace arcspan::tools
