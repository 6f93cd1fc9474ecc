// SPDX-License-Identifier: MIT
// Arbitrary bytes as a mesh, a texture and a model binary, with animation. If the first byte is odd, its next
// two bits choose a kind whose magic number, version, size and checksum are made right, so that what lies
// behind them is reached. A binary is either refused or all of it can be read; the bytes lie in memory of
// exactly their size, so that the address sanitizer sees one read too many.
#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/model/model_neighbours.hpp>
#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>

using namespace arcspan;

namespace {

using Bytes = std::span<std::uint8_t>;

void require(bool promise) {
  if (!promise) std::abort();
}

void put_u32(std::uint8_t* at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

/// Makes magic number, version (`first` or one of the `versions` - 1 after it) and size right. All kinds have
/// them at the same offsets.
void close_header(Bytes bytes, const char* magic, unsigned first, unsigned versions) {
  std::memcpy(bytes.data(), magic, 4);
  bytes[4] = static_cast<std::uint8_t>(first + bytes[4] % versions);
  bytes[5] = 0;
  put_u32(bytes.data() + mesh_binary::kSizeAt, static_cast<std::uint32_t>(bytes.size()));
}

/// Makes the last four bytes the checksum of the others.
void close(Bytes bytes) {
  const std::size_t covered = bytes.size() - 4;
  put_u32(bytes.data() + covered, crc32(bytes.first(covered)));
}

void close_mesh_header(Bytes bytes) {
  if (bytes.size() >= mesh_binary::kHeaderBytes) close_header(bytes, "ARCM", 1, 4);
}

void close_texture_header(Bytes bytes) {
  if (bytes.size() >= texture_binary::kHeaderBytes) close_header(bytes, "ARCT", 2, 1);
}

/// The bytes that offset and size at `at` name, or none.
Bytes range_at(Bytes bytes, const std::uint8_t* at) {
  const std::uint32_t begin = little_u32(at);
  const std::uint32_t size = little_u32(at + 4);
  return begin <= bytes.size() && size <= bytes.size() - begin ? bytes.subspan(begin, size) : Bytes();
}

/// Also makes the headers of meshes and textures right that a table of chunks names.
void close_model_header(Bytes bytes) {
  if (bytes.size() < chunk_list::kHeaderBytes + 4) return;
  close_header(bytes, "ARCP", 3, 1);
  const std::size_t most = (bytes.size() - chunk_list::kHeaderBytes - 4) / chunk_list::kEntryBytes;
  std::uint8_t* const count = bytes.data() + chunk_list::kChunksAt;
  *count = static_cast<std::uint8_t>(*count % (most < 255 ? most + 1 : 255));
  count[1] = 0;
  for (std::size_t i = 0; i < *count; ++i) {
    const std::uint8_t* const entry = bytes.data() + chunk_list::kHeaderBytes + i * chunk_list::kEntryBytes;
    const Bytes chunk = range_at(bytes, entry + chunk_list::kBeginAt);
    if (chunk.data() < entry) continue;  // it would write over this entry
    if (std::memcmp(entry, "MESH", 4) == 0) close_mesh_header(chunk);
    if (std::memcmp(entry, "TXTR", 4) == 0) close_texture_header(chunk);
  }
}

volatile std::int32_t kept;  // the reads must stay

void read_all(const MeshView& mesh) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    sum += mesh.position(i).x + mesh.position(i).z + mesh.normal(i).u + mesh.normal(i).v;
    sum += mesh.texture_point(i).u + mesh.texture_point(i).v;
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (mesh.planes() != nullptr) sum += mesh.planes()[i].x + mesh.planes()[i].offset;
    const TriangleIndices t = mesh.triangle(i);
    require(t.a < mesh.vertex_count() && t.b < mesh.vertex_count() && t.c < mesh.vertex_count());
  }
  kept = sum;
}

template <TexelFormat Texels>
void read_as(const StoredTexture& stored) {
  Texture<Texels> texture;
  const Status status = view_texture(stored, texture);
  require(ok(status) == has_format<Texels>(stored));
  if (!ok(status)) return;
  std::int32_t sum = 0;
  for (std::uint32_t i = 0; i < texture.size().texels(texture.size().levels); ++i) {
    sum += Texels::stored(texture.at(0), texture.palette(), i);
  }
  kept = sum;
}

void read_all(const StoredTexture& stored) {
  require(stored.size.valid());
  read_as<DirectTexels<>>(stored);
  read_as<DirectTexels<Alpha4Colour>>(stored);
  read_as<Palette8Texels<>>(stored);
  read_as<Palette4Texels<>>(stored);
  read_as<Palette4Texels<Alpha1Colour>>(stored);
  read_as<GrayTexels>(stored);
}

/// Reads all that neighbours say, as OutlineList::add() does.
void read_all(const MeshView& mesh, const MeshNeighbours& neighbours) {
  require(neighbours.triangle_count() == mesh.triangle_count());
  const std::uint8_t* at = neighbours.bytes();
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const std::uint8_t* const first = at;
    const unsigned kinds = *at++;
    for (unsigned edge = 0; edge < 3; ++edge) {
      if (!detail::has_distance(detail::edge_kind(kinds, edge))) continue;
      require(i + detail::read_distance(at) < mesh.triangle_count());
    }
    if (const unsigned distances = detail::short_distances(kinds); distances != 0) {
      require(detail::has_ordinary_edges(kinds));
      require(at == first + 1 + distances);
    }
  }
}

void read_neighbours(const StoredModel& model, std::size_t i) {
  MeshNeighbours neighbours;
  if (ok(view_neighbours(model, i, neighbours))) {
    read_all(model.part(i).mesh, neighbours);
  } else {
    require(neighbours.bytes() == nullptr);
  }
}

/// The vertices of a part that follows joints and may have morph targets, in some pose.
void read_posed(const StoredAnimation& animation, const MeshView& mesh, std::size_t part,
                const ClipBlend& blend, std::span<const NodeMatrix> nodes) {
  std::int16_t weights[animation_binary::kMostTargets];
  JointMatrix joints[animation_binary::kMostJoints];
  require(ok(pose_morph(animation, part, blend, weights)));
  const std::size_t skin = animation.weights(part).skin();
  require(ok(pose_joints(animation.skin(skin), nodes, joints)));
  SkinnedMesh skinned;
  require(ok(SkinnedMesh::make(mesh, animation, part, joints, skinned)));
  MorphedMesh morphed;
  MorphedSkinnedMesh both;
  const bool morphs = ok(MorphedMesh::make(mesh, animation, part, weights, morphed));
  require(morphs == (animation.morph(part).target_count() != 0));
  if (morphs) require(ok(MorphedSkinnedMesh::make(morphed, animation, part, joints, both)));
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    sum += skinned.position(i).x + skinned.direction(i).y.raw();
    if (morphs) sum += both.position(i).x + both.direction(i).y.raw();
    const VertexJoints joint = animation.weights(part).vertex(i);
    require(joint.count >= 1 && joint.weights[0] >= 1);
  }
  for (const JointBound& bound : animation.bounds(part)) sum += bound.sphere.radius;
  kept = sum;
}

void read_animation(const StoredModel& model) {
  StoredAnimation animation;
  if (!ok(view_animation(model, animation))) {
    require(animation.nodes().empty());
    return;
  }
  NodeMatrix nodes[animation_binary::kMostNodes];
  for (std::size_t clip = 0; clip <= animation.clip_count(); ++clip) {
    // At last none.
    const StoredClip played = clip < animation.clip_count() ? animation.clip(clip) : StoredClip();
    require(std::strlen(played.name()) < animation_binary::kNameBytes);
    for (const std::uint32_t time : {0u, played.duration() / 3, played.duration()}) {
      const ClipBlend blend{{played, time},
                            {animation.clip_count() != 0 ? animation.clip(0) : StoredClip(), time},
                            time % 65537};
      require(ok(pose_nodes(animation, blend, nodes)));
      for (std::size_t part = 0; part < model.part_count(); ++part) {
        if (animation.weights(part).exist())
          read_posed(animation, model.part(part).mesh, part, blend, {nodes, animation.nodes().size()});
      }
    }
  }
  for (std::size_t i = 0; i < animation.nodes().size(); ++i)
    require(animation.find_node(animation.node_name(i)) <= i);
}

void read_model(std::span<const std::uint8_t> bytes) {
  StoredModel model;
  if (!ok(view_model_binary(bytes, model))) {
    require(model.part_count() == 0);
    return;
  }
  for (std::size_t i = 0; i < model.part_count(); ++i) {
    const ModelPart part = model.part(i);
    read_all(part.mesh);
    read_neighbours(model, i);
    require(part.mesh.vertex_count() <= model.most_vertices());
    require(std::strlen(part.name) < model_binary::kNameBytes);
    if (!part.texture.texels.empty()) read_all(part.texture);
  }
  read_animation(model);
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < model.chunks().size(); ++i) {
    const Chunk chunk = model.chunks()[i];
    for (const std::uint8_t byte : chunk.bytes) sum += byte;
    require(model.chunks().find(chunk.tag, chunk.number).data() == chunk.bytes.data());
  }
  kept = sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::size_t length = size - 1;
  const std::unique_ptr<std::uint8_t, decltype(&std::free)> memory(
      static_cast<std::uint8_t*>(std::malloc(length)), &std::free);
  if (length > 0) std::memcpy(memory.get(), data + 1, length);
  const Bytes bytes(memory.get(), length);
  const unsigned kind = (data[0] >> 1) % 3;
  if ((data[0] & 1u) != 0) {
    if (kind == 0) close_mesh_header(bytes);
    if (kind == 1) close_texture_header(bytes);
    if (kind == 2) close_model_header(bytes);
    if (length >= 4) close(bytes);
  }
  MeshView mesh;
  if (ok(view_mesh_binary(bytes, mesh))) {
    read_all(mesh);
  } else {
    require(mesh == MeshView());
  }
  StoredTexture texture;
  if (ok(view_texture_binary(bytes, texture))) {
    read_all(texture);
  } else {
    require(texture.texels.empty());
  }
  read_model(bytes);
  return 0;
}
