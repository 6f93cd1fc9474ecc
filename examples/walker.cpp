// SPDX-License-Identifier: MIT
// A character on a display: it stands, starts to walk and turns, drawn in bands on an ST7789 of 240x320
// pixels. The model lies in flash as `arcspan mesh` wrote it; joints are computed once per frame, vertices
// when the first band needs them. For a board of your own, write an St7789Board with its SPI bus and pins
// (docs/hal.md).
#include "walker/model.h"

#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <st7789_board.hpp>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;
using Method = Arc<Light>;
using Pages = hal::PageMode<hal::St7789>;

// The numbers of nodes, joints, parts, vertices and triangles of the model, which `arcspan mesh` prints.
constexpr std::size_t kNodes = 14, kJoints = 18, kParts = 4, kVertices = 646, kTriangles = 1132;
constexpr std::int32_t kRows = 16;
constexpr Direction kSun = normalised(2, 3, 4);
constexpr Direction kToEye = normalised(0, 0, 1);

// A part of the model, and what of the memory below is its own.
struct Part {
  ModelPart stored;
  std::span<const StoredJoint> skin;
  std::span<JointMatrix> joints;
  VertexCache<Method> cache{{}};
  SkinnedMesh mesh;
  Light light;
};

class Walker {
 public:
  Status load() {
    StoredModel model;
    Status status = view_model_binary(walker::kModel, model);
    if (ok(status)) status = view_animation(model, animation_);
    if (!ok(status)) return status;
    if (model.part_count() != kParts) return Status::kInvalidArgument;
    std::span<JointMatrix> joints = joints_;
    std::span<CachedVertex<Method>> vertices = vertices_;
    std::span<TriangleRows> rows = rows_;
    for (std::size_t i = 0; i < kParts && ok(status); ++i) {
      Part& part = parts_[i];
      part.stored = model.part(i);
      part.skin = animation_.skin(animation_.weights(i).skin());
      const std::size_t count = part.stored.mesh.vertex_count();
      const std::size_t entries = TriangleRows::entries(part.stored.mesh.triangle_count());
      if (joints.size() < part.skin.size() || vertices.size() < count || rows.size() < entries)
        return Status::kBufferTooSmall;
      part.joints = joints.first(part.skin.size());
      part.cache = VertexCache<Method>(vertices.first(count), rows.first(entries));
      joints = joints.subspan(part.skin.size());
      vertices = vertices.subspan(count);
      rows = rows.subspan(entries);
      status = Light::make(part.stored.material, {DirectionalLight{kSun}}, kToEye, part.light);
    }
    player_.play(clip("stand"));
    return status;
  }

  void walk() { player_.fade_to(clip("walk"), 200'000); }

  // The pose so many microseconds later, and its light.
  Status advance(std::uint32_t microseconds, const Rotation& rotation) {
    player_.advance(microseconds);
    Status status = pose_nodes(animation_, player_.blend(), nodes_);
    for (std::size_t i = 0; i < kParts && ok(status); ++i) {
      Part& part = parts_[i];
      part.cache.clear();
      status = pose_joints(part.skin, nodes_, part.joints);
      if (ok(status)) status = SkinnedMesh::make(part.stored.mesh, animation_, i, part.joints, part.mesh);
      part.light.set_directions({rotation.to_object(kSun)}, rotation.to_object(kToEye));
    }
    return status;
  }

  Status draw(const ClipTransform& transform, Pages::Frame& band, const DepthBuffer& depth) {
    Status status = Status::kOk;
    for (Part& part : parts_) {
      if (ok(status))
        status = draw_mesh<Method>(part.mesh, transform, part.light, band, depth, part.cache).status;
    }
    return status;
  }

 private:
  [[nodiscard]] StoredClip clip(const char* name) const {
    const std::size_t number = animation_.find_clip(name);
    return number == StoredAnimation::kNone ? StoredClip() : animation_.clip(number);
  }

  StoredAnimation animation_;
  ClipPlayer player_;
  NodeMatrix nodes_[kNodes];
  JointMatrix joints_[kJoints];
  CachedVertex<Method> vertices_[kVertices];
  TriangleRows rows_[TriangleRows::entries(kTriangles)];
  Part parts_[kParts];
};

Pages::Frame::Word band_memory[Pages::Frame::words(240, kRows)];
std::uint8_t wire_memory[hal::wire_bytes<hal::St7789>(240, kRows)];
std::uint16_t depth_memory[DepthBuffer::words(240, kRows)];

Status draw_frame(Walker& walker, Pages& pages, const Rotation& rotation) {
  Placement placement{rotation, {}};
  placement.translation[2] = ObjectLength::of(-112'000);
  ClipTransform transform;
  Status status = ClipTransform::make(
      placement, {PixelLength::of(480), ObjectLength::of(60'000), ObjectLength::of(160'000)}, {240, 320},
      transform);
  if (ok(status)) status = walker.advance(60'000, rotation);
  if (!ok(status)) return status;
  return pages.show([&](Pages::Frame& band) {
    DepthBuffer depth(depth_memory, 240, kRows, band.bounds().top);
    depth.clear();
    band.clear({20, 30, 60});
    return walker.draw(transform, band, depth);
  });
}

int main() {
  static Walker walker;  // too large for the stack
  St7789Board board;
  Pages pages(board.panel(), band_memory, wire_memory, kRows);
  Status status = walker.load();
  if (ok(status)) status = board.start();
  for (std::uint16_t frame = 0; ok(status) && frame < 20; ++frame) {
    if (frame == 2) walker.walk();
    status = draw_frame(walker, pages, Rotation::about_y({static_cast<std::uint16_t>(frame * 3000)}));
  }
  return ok(status) ? 0 : 1;
}
