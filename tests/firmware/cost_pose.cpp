// SPDX-License-Identifier: MIT
// Poses the tubes that tests/artefacts/posing_models.cpp has written and the emulator has loaded,
// for scripts/simulate-estimates, transforms and shades their vertices, clears a picture and packs it for a
// panel. With ARCSPAN_COST_MORPHS it does nothing but transform and shade what morph targets move: a program
// of its own, because the compiler inlines otherwise in one with more kinds of meshes. The name of a section
// ends with the number of what it made.
#include <arcspan/animate/morphed_mesh.hpp>
#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <tests/firmware/cost_record.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>

using namespace arcspan;

namespace {

using Method = Arc<Illumination<1, Highlight::kBlinn>>;

constexpr std::int32_t kWidth = 320;
constexpr std::int32_t kHeight = 240;
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[1024];
Method::Lighting light;
ClipTransform transform;

/// A camera that sees a model of 16 bits, and a light.
bool make_view() {
  Placement placement{};
  placement.translation[2] = ObjectLength::of(-200000);
  constexpr Coefficient kPart = Coefficient::of(0.4);
  const Material material{{kPart, kPart, kPart}, {kPart, kPart, kPart}, {kPart, kPart, kPart}, 16};
  return ok(ClipTransform::make(placement,
                                {PixelLength::of(500), ObjectLength::of(50000), ObjectLength::of(400000)},
                                {kWidth, kHeight}, transform)) &&
         ok(Method::Lighting::make(material, {DirectionalLight{normalised(1, 2, 3)}}, normalised(0, 0, 1),
                                   light));
}

template <class Work>
void measure(const char* name, const char* of, std::size_t count, const Work& work) {
  arcspan_mark();
  work();
  arcspan_mark();
  bare::print_line("section: ", name, of, " ", static_cast<std::uint32_t>(count));
  bare::print_line("section: between");
}

/// The vertices as draw_mesh() transforms and shades them.
template <class Mesh>
bool measure_vertices(const char* of, const MeshView& view, const Mesh& mesh) {
  const std::size_t vertices = view.vertex_count();
  if (vertices > std::size(cache)) return false;
  const VertexStage<Method, Mesh> stage(mesh, transform, light);
  measure("position ", of, vertices, [&] { stage.transform_all(cache); });
  measure("normal ", of, vertices, [&] {
    for (std::size_t i = 0; i < vertices; ++i) stage.shade(i, cache[i]);
  });
  return true;
}

#ifdef ARCSPAN_COST_MORPHS

bool measure_model(const char* name, const ModelPart& part, const StoredAnimation& animation) {
  if (animation.morph(0).target_count() == 0) return true;
  std::int16_t weights[4] = {};
  MorphedMesh mesh;
  return ok(pose_morph(animation, 0, ClipBlend(), weights)) &&
         ok(MorphedMesh::make(part.mesh, animation, 0, weights, mesh)) &&
         measure_vertices(name, part.mesh, mesh);
}

void measure_picture() {}

#else

[[gnu::section(".bss.frame")]] std::uint16_t colours[kWidth * kHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kWidth * kHeight];
[[gnu::section(".bss.frame")]] std::uint8_t wire[2 * kWidth * kHeight];

NodeMatrix nodes[32];
JointMatrix joints[32];

template <class Layout>
void measure_packing(const char* format) {
  using Frame = hal::Framebuffer<typename Layout::Format>;
  static_assert(sizeof(typename Frame::Word) <= sizeof colours[0]);
  const Frame frame(
      {static_cast<typename Frame::Word*>(static_cast<void*>(colours)), Frame::words(kWidth, kHeight)},
      kWidth, kHeight);
  measure("pack ", format, std::size_t{kWidth} * kHeight,
          [&] { Layout::pack(frame, frame.bounds(), hal::Orientation::k0, wire); });
}

bool measure_model(const char* name, const ModelPart& part, const StoredAnimation& animation) {
  if (animation.morph(0).target_count() != 0) return true;
  ClipPlayer player(animation.clip(0));
  player.seek(330'000);
  Status status = Status::kOk;
  measure("node", "", animation.nodes().size(),
          [&] { status = pose_nodes(animation, player.blend(), nodes); });
  if (!ok(status)) return false;
  const auto skin = animation.skin(0);
  measure("joint", "", skin.size(), [&] { status = pose_joints(skin, nodes, joints); });
  SkinnedMesh mesh;
  if (!ok(status) || !ok(SkinnedMesh::make(part.mesh, animation, 0, joints, mesh))) return false;
  return measure_vertices("0", part.mesh, part.mesh) &&  // at rest
         measure_vertices(name, part.mesh, mesh);
}

void measure_picture() {
  hal::Framebuffer<Rgb565> frame(colours, kWidth, kHeight);
  DepthBuffer depth(depths, kWidth, kHeight);
  measure("clear", "", std::size_t{kWidth} * kHeight, [&] {
    frame.clear({0, 0, 0});
    depth.clear();
  });
  measure_packing<hal::BigEndianRgb565>("rgb565");
  measure_packing<hal::Gray4Pairs>("gray4");
  measure_packing<hal::MonoPages>("mono");
}

#endif

bool measure_record(const ModelRecord& record) {
  StoredModel model;
  StoredAnimation animation;
  return ok(view_model_binary(binary_of(record), model)) && ok(view_animation(model, animation)) &&
         measure_model(record.name, model.part(0), animation);
}

}  // namespace

int main() {
  if (!make_view()) return 1;
  measure_picture();
  for (const ModelRecord* record = &first_record(); record->bytes != 0; record = &next_record(*record)) {
    if (!measure_record(*record)) return 1;
  }
  return 0;
}
