// SPDX-License-Identifier: MIT
// Characters from C: their pictures are those of C++, and what is wrong is refused.
#include "examples/walker/model.h"

#include <arcspan/animate/attachment.hpp>
#include <arcspan/animate/posed_bound.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/scene.hpp>

#include <arcspan.h>
#include <arcspan_c/character.hpp>
#include <arcspan_c/character_mesh.hpp>
#include <arcspan_c/model.hpp>
#include <catch2/catch.hpp>
#include <tests/support/animated_rig.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

extern "C" {
extern const arcspan_model ball;
}

namespace {

using namespace arcspan;

constexpr std::int32_t kSide = 80;
constexpr arcspan_rgb kBlack = {0, 0, 0};
constexpr arcspan_lens kLens = {kSide, kSide, ARCSPAN_DEGREES(40), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(9)};
constexpr arcspan_point kEye = {0, ARCSPAN_LENGTH(0.5), ARCSPAN_LENGTH(3.2)};
constexpr arcspan_point kAt = {ARCSPAN_LENGTH(-0.3), ARCSPAN_LENGTH(0.1), ARCSPAN_LENGTH(0.2)};
constexpr auto* kWalker = static_cast<const std::uint8_t*>(walker::kModel);
constexpr std::size_t kWalkerBytes = sizeof walker::kModel;

/// A walker and a ball in front of it, in memory that has no byte more than is asked for.
struct Stage {
  std::vector<unsigned char> scene_memory;
  std::vector<unsigned char> memory;
  arcspan_scene* scene = nullptr;
  arcspan_character* character = nullptr;
  arcspan_object held = 0;

  explicit Stage(const arcspan_look* look = nullptr, std::uint16_t materials = 9)
      : memory(arcspan_character_bytes(kWalker, kWalkerBytes)) {
    const arcspan_scene_limits limits{6, materials};
    scene_memory.resize(arcspan_scene_bytes(&limits));
    REQUIRE(arcspan_scene_make(scene_memory.data(), scene_memory.size(), &limits, &scene) == ARCSPAN_OK);
    REQUIRE(arcspan_add_model(scene, &ball, &held) == ARCSPAN_OK);
    REQUIRE(arcspan_set_scale(scene, held, ARCSPAN_LENGTH(0.2)) == ARCSPAN_OK);
    REQUIRE(add(memory.data(), memory.size(), look) == ARCSPAN_OK);
    const arcspan_object object = arcspan_object_of(character);
    CHECK(object == held + 1);
    REQUIRE(arcspan_set_position(scene, object, kAt) == ARCSPAN_OK);
    REQUIRE(arcspan_set_angles(scene, object, 5000, 300, 0) == ARCSPAN_OK);
  }
  [[nodiscard]] arcspan_status add(void* at, std::size_t bytes, const arcspan_look* look = nullptr) {
    return arcspan_add_character(scene, kWalker, kWalkerBytes, look, at, bytes, &character);
  }
  /// The picture in bands of so many rows.
  [[nodiscard]] std::vector<std::uint16_t> drawn(std::int32_t rows = kSide, int keeps_vertices = 1) const {
    const arcspan_view_limits limits = arcspan_limits_of(scene, keeps_vertices);
    std::vector<unsigned char> view_memory(arcspan_view_bytes(&limits));
    arcspan_view* view = nullptr;
    REQUIRE(arcspan_view_make(view_memory.data(), view_memory.size(), &limits, scene, &view) == ARCSPAN_OK);
    REQUIRE(arcspan_set_camera(view, &kLens, kEye, {0, 0, 0}, {0, 0, 0}) == ARCSPAN_OK);
    REQUIRE(arcspan_prepare(view) == ARCSPAN_OK);
    std::vector<std::uint16_t> pixels(kSide * kSide), depths(kSide * static_cast<std::size_t>(rows));
    for (std::int32_t y = 0; y < kSide; y += rows) {
      std::uint16_t* const first = pixels.data() + kSide * y;
      const arcspan_target target{
          first,         2 * depths.size(), 2 * kSide, ARCSPAN_RGB565, {0, y, kSide, y + rows},
          depths.data(), depths.size(),     &kBlack};
      REQUIRE(arcspan_draw(view, &target) == ARCSPAN_OK);
    }
    return pixels;
  }
};

/// The walker in C++, as a player poses it.
struct CppWalker {
  StoredModel model;
  StoredAnimation animation;
  ClipPlayer player;
  NodeMatrix nodes[14];
  JointMatrix joints[4][8];
  SkinnedMesh meshes[4];
  ModelPart parts[4];
  BoundingSphere spheres[4];

  CppWalker() {
    REQUIRE(ok(view_model_binary(walker::kModel, model)));
    REQUIRE(ok(view_animation(model, animation)));
    REQUIRE(model.part_count() == 4);
  }
  void pose() {
    REQUIRE(ok(pose_nodes(animation, player.blend(), nodes)));
    for (std::size_t i = 0; i < 4; ++i) {
      const auto skin = animation.skin(animation.weights(i).skin());
      parts[i] = model.part(i);
      REQUIRE(ok(pose_joints(skin, nodes, joints[i])));
      REQUIRE(ok(SkinnedMesh::make(parts[i].mesh, animation, i, joints[i], meshes[i])));
      spheres[i] = posed_bound(animation.bounds(i), std::span(joints[i]).first(skin.size()));
    }
  }
  [[nodiscard]] std::vector<std::uint16_t> drawn(const LightList& lights, const Object& held) const {
    using Method = Arc<c::Light>;
    std::vector<PreparedMaterial<Method>> materials(4);
    std::vector<PosedMaterial<SkinnedMesh>> posed;
    posed.reserve(4);
    std::vector<Object> objects{held};
    for (std::size_t i = 0; i < 4; ++i) {
      REQUIRE(ok(PreparedMaterial<Method>::make(parts[i].material, lights, {}, materials[i])));
      posed.emplace_back(materials[i], meshes[i]);
      objects.emplace_back(parts[i].mesh, posed[i], spheres[i]);
      objects.back().position = c::world_point(kAt);
      objects.back().rotation = rotation_of(EulerAngles{{5000}, {300}, {0}});
    }
    Camera camera;
    const Lens lens = Lens::field_of_view(Turn{ARCSPAN_DEGREES(40)}, WorldLength::of(1), WorldLength::of(9));
    REQUIRE(ok(Camera::make({c::world_point(kEye), {}}, lens, {kSide, kSide}, camera)));
    std::vector<std::uint16_t> pixels(kSide * kSide), depths(kSide * kSide);
    hal::Framebuffer<Rgb565> frame(pixels, kSide, kSide);
    static SceneMemory<MethodList<Method, Posed<Method, SkinnedMesh>>, 5, 900> memory;
    REQUIRE(ok(draw_scene({camera, lights, objects}, frame, DepthBuffer(depths, kSide, kSide), memory, Rgb8{})
                   .status));
    return pixels;
  }
};

TEST_CASE("a character that fades from one clip to another is drawn from C with the pixels of C++") {
  Stage stage;
  CppWalker expected;
  const uint16_t walk = arcspan_find_clip(stage.character, "walk");
  const uint16_t stand = arcspan_find_clip(stage.character, "stand");
  const auto at_rest = stage.drawn();
  arcspan_advance(stage.character, 0);
  CHECK(stage.drawn() == at_rest);
  REQUIRE(arcspan_play(stage.character, walk, 0, ARCSPAN_REPEAT) == ARCSPAN_OK);
  expected.player.play(expected.animation.clip(walk));
  arcspan_set_speed(stage.character, ARCSPAN_LENGTH(1.5));
  expected.player.set_speed(ClipSpeed::of(1.5));
  for (int step = 0; step < 3; ++step) {
    arcspan_advance(stage.character, 170'000);
    expected.player.advance(170'000);
    if (step == 1) {
      REQUIRE(arcspan_play(stage.character, stand, 400'000, ARCSPAN_STOP) == ARCSPAN_OK);
      expected.player.fade_to(expected.animation.clip(stand), 400'000, AtClipEnd::kStop);
    }
    expected.pose();
    REQUIRE(arcspan_attach(stage.character, arcspan_find_node(stage.character, "forearm R"), stage.held) ==
            ARCSPAN_OK);
    const SceneLight light = SceneLight::directional(normalised(-1, 1, 2));
    const auto picture = expected.drawn({{&light, 1}}, *stage.scene->parts_of(stage.held).data());
    CHECK(stage.drawn() == picture);
    CHECK(stage.drawn(16) == picture);
    CHECK(stage.drawn(20, 0) == picture);
    CHECK(picture != at_rest);
  }
}

TEST_CASE("a character is drawn by another material, and by its own again") {
  const Stage stage;
  const std::uint16_t clip = arcspan_find_clip(stage.character, "walk");
  REQUIRE(arcspan_play(stage.character, clip, 0, ARCSPAN_REPEAT) == ARCSPAN_OK);
  arcspan_advance(stage.character, 300000);
  const auto own = stage.drawn();
  const arcspan_object object = arcspan_object_of(stage.character);
  const arcspan_shares none{0, 0, 0}, white{32768, 32768, 32768}, dark{9000, 9000, 9000};
  const arcspan_light light{{-1, 1, 2}, 0, 32768, white};
  for (const std::uint16_t share : {std::uint16_t{20000}, std::uint16_t{30000}}) {
    CAPTURE(share);
    const arcspan_material red{{6000, 0, 0}, {share, 0, 0}, none, 1};
    const arcspan_look look{ARCSPAN_ARC, 1, 0, &red, 0};
    Stage expected(&look);
    REQUIRE(arcspan_play(expected.character, clip, 0, ARCSPAN_REPEAT) == ARCSPAN_OK);
    arcspan_advance(expected.character, 300000);
    REQUIRE(arcspan_set_material(stage.scene, object, &red) == ARCSPAN_OK);
    CHECK((stage.drawn() == expected.drawn()));
    CHECK((stage.drawn(16, 0) == expected.drawn()));
    arcspan_advance(stage.character, 100000);
    arcspan_advance(expected.character, 100000);
    CHECK((stage.drawn() == expected.drawn()));
    REQUIRE(arcspan_set_lights(stage.scene, &light, 1, dark) == ARCSPAN_OK);
    REQUIRE(arcspan_set_lights(expected.scene, &light, 1, dark) == ARCSPAN_OK);
    CHECK((stage.drawn() == expected.drawn()));
    REQUIRE(arcspan_set_lights(stage.scene, &light, 1, white) == ARCSPAN_OK);
    arcspan_seek(stage.character, 300000);
    arcspan_advance(stage.character, 0);
    REQUIRE(arcspan_set_material(stage.scene, object, nullptr) == ARCSPAN_OK);
    CHECK((stage.drawn() == own));
  }
}

TEST_CASE("a character is translucent while it moves, and opaque again") {
  const Stage stage;
  const Stage opaque;
  const arcspan_object object = arcspan_object_of(stage.character);
  for (const Stage* each : {&stage, &opaque})
    REQUIRE(arcspan_play(each->character, arcspan_find_clip(each->character, "walk"), 0, ARCSPAN_REPEAT) ==
            ARCSPAN_OK);
  REQUIRE(arcspan_set_opacity(stage.scene, object, ARCSPAN_SHARE(0.5)) == ARCSPAN_OK);
  std::vector<std::uint16_t> before;
  for (int i = 0; i < 2; ++i) {
    for (const Stage* each : {&stage, &opaque}) arcspan_advance(each->character, 300000);
    const auto faint = stage.drawn();
    CHECK((faint != opaque.drawn()));
    CHECK((faint != before));
    CHECK((stage.drawn(16) == faint));
    CHECK((stage.drawn(20, 0) == faint));
    before = faint;
  }
  REQUIRE(arcspan_set_opacity(stage.scene, object, ARCSPAN_SHARE(1)) == ARCSPAN_OK);
  CHECK((stage.drawn() == opaque.drawn()));
}

TEST_CASE("parts of a character share a material that is made anew where another was") {
  const arcspan_material red{{6000, 0, 0}, {30000, 0, 0}, {0, 0, 0}, 1};
  Stage roomy;
  Stage full(nullptr, 5);
  for (const arcspan_share opacity :
       {ARCSPAN_SHARE(1), ARCSPAN_SHARE(0.5), ARCSPAN_SHARE(0.75), ARCSPAN_SHARE(1)}) {
    CAPTURE(opacity);
    for (const Stage* each : {&roomy, &full}) {
      const arcspan_object object = arcspan_object_of(each->character);
      REQUIRE(arcspan_set_material(each->scene, object, &red) == ARCSPAN_OK);
      REQUIRE(arcspan_set_opacity(each->scene, object, opacity) == ARCSPAN_OK);
    }
    CHECK((full.drawn() == roomy.drawn()));
  }
}

TEST_CASE("an object that is attached follows the node through the character's placement") {
  Stage stage;
  const arcspan_object object = arcspan_object_of(stage.character);
  REQUIRE(arcspan_set_scale(stage.scene, object, ARCSPAN_LENGTH(2)) == ARCSPAN_OK);
  REQUIRE(arcspan_play(stage.character, arcspan_find_clip(stage.character, "walk"), 0, 1) == ARCSPAN_OK);
  arcspan_advance(stage.character, 250'000);
  const uint16_t arm = arcspan_find_node(stage.character, "forearm R");
  REQUIRE(arm != ARCSPAN_NONE);
  REQUIRE(arcspan_attach(stage.character, arm, stage.held) == ARCSPAN_OK);
  const NodeMatrix& node = stage.character->nodes[arm];
  const Object& body = *stage.scene->parts_of(object).data();
  const Object& held = *stage.scene->parts_of(stage.held).data();
  const std::int32_t places[3] = {held.position.x.raw(), held.position.y.raw(), held.position.z.raw()};
  arcspan_point at;
  REQUIRE(arcspan_node_position(stage.character, arm, &at) == ARCSPAN_OK);
  CHECK(std::equal(places, places + 3, std::array{at.x, at.y, at.z}.begin()));
  const std::int32_t origin[3] = {kAt.x, kAt.y, kAt.z};
  for (std::size_t i = 0; i < 3; ++i) {
    double expected = origin[i];
    for (std::size_t j = 0; j < 3; ++j)
      expected +=
          std::ldexp(body.rotation.m[i][j].raw(), -30) * node.offset[j].raw() * 2 * 65536 / 256 / 32768;
    CHECK(places[i] == Approx(expected).margin(2));
    for (std::size_t j = 0; j < 3; ++j) {
      double entry = 0;
      for (std::size_t k = 0; k < 3; ++k)
        entry += std::ldexp(body.rotation.m[i][k].raw(), -30) * std::ldexp(node.entries[k][j], -24);
      CHECK(std::ldexp(held.rotation.m[i][j].raw(), -30) == Approx(entry).margin(1e-5));
    }
  }
  CHECK(held.scale.raw() == ARCSPAN_LENGTH(0.2));
  REQUIRE(arcspan_set_position(stage.scene, object, {INT32_MAX, INT32_MIN, 0}) == ARCSPAN_OK);
  for (uint16_t i = 0; i < 14; ++i) {
    REQUIRE(arcspan_node_position(stage.character, i, &at) == ARCSPAN_OK);
    CHECK((at.x > 0 && at.y < 0));
  }
}

TEST_CASE("materials of characters follow the light") {
  Stage stage;
  const auto white = stage.drawn();
  const arcspan_light light{{-1, 1, 2}, 0, 32768, {32768, 32768, 32768}};
  REQUIRE(arcspan_set_lights(stage.scene, &light, 1, {0, 0, 0}) == ARCSPAN_OK);
  CHECK(stage.drawn() != white);
}

TEST_CASE("clips of a character have names, lengths, ends and speeds") {
  Stage stage;
  arcspan_character* const character = stage.character;
  REQUIRE(arcspan_clip_count(character) == 2);
  const uint16_t walk = arcspan_find_clip(character, "walk");
  CHECK(std::string(arcspan_clip_name(character, walk)) == "walk");
  CHECK(arcspan_clip_name(character, 2) == std::string());
  const uint32_t length = arcspan_clip_length(character, walk);
  CHECK(length > 500'000);
  CHECK(arcspan_clip_length(character, 2) == 0);
  CHECK(arcspan_find_clip(character, "wal") == ARCSPAN_NONE);
  CHECK(arcspan_find_clip(character, nullptr) == ARCSPAN_NONE);
  CHECK(arcspan_find_node(character, "tail") == ARCSPAN_NONE);
  CHECK(arcspan_find_node(character, nullptr) == ARCSPAN_NONE);

  REQUIRE(arcspan_play(character, walk, 0, ARCSPAN_REPEAT) == ARCSPAN_OK);
  arcspan_advance(character, length + 1000);
  CHECK(arcspan_clip_time(character) == 1000);
  CHECK(arcspan_has_ended(character) == 0);
  REQUIRE(arcspan_play(character, walk, 0, ARCSPAN_STOP) == ARCSPAN_OK);
  arcspan_set_speed(character, -ARCSPAN_LENGTH(2));
  arcspan_seek(character, 700);
  arcspan_advance(character, 100);
  CHECK(arcspan_clip_time(character) == 500);
  CHECK(arcspan_has_ended(character) == 0);
  arcspan_advance(character, UINT32_MAX);
  CHECK(arcspan_clip_time(character) == 0);
  CHECK(arcspan_has_ended(character) == 1);
}

TEST_CASE("the box of a character contains its pose") {
  Stage stage;
  CppWalker expected;
  const uint16_t walk = arcspan_find_clip(stage.character, "walk");
  REQUIRE(arcspan_play(stage.character, walk, 0, ARCSPAN_REPEAT) == ARCSPAN_OK);
  arcspan_advance(stage.character, 300'000);
  expected.player.play(expected.animation.clip(walk));
  expected.player.advance(300'000);
  expected.pose();
  const arcspan_object object = arcspan_object_of(stage.character);
  REQUIRE(arcspan_set_angles(stage.scene, object, 0, 0, 0) == ARCSPAN_OK);
  constexpr std::int32_t kFar = 1 << 29;
  arcspan_box box{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};  // what it held
  REQUIRE(arcspan_bounds(stage.scene, object, &box) == ARCSPAN_OK);
  std::int32_t low = INT32_MAX, high = INT32_MIN;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t v = 0; v < expected.parts[i].mesh.vertex_count(); ++v) {
      const std::int32_t y = kAt.y + 2 * expected.meshes[i].position(v).y;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  CHECK(box.least.y <= low);
  CHECK(box.most.y >= high);
  CHECK(box.most.y - box.least.y < 2 * (high - low));
  CHECK(arcspan_bounds(stage.scene, 77, &box) == ARCSPAN_INVALID_ARGUMENT);
}

TEST_CASE("a character that cannot be added changes nothing in a scene") {
  Stage stage;
  arcspan_character* const kept = stage.character;
  std::vector<std::uint32_t> words(kWalkerBytes / 4 + 1);
  auto* const bytes = reinterpret_cast<unsigned char*>(words.data());
  std::memcpy(bytes, kWalker, kWalkerBytes);
  const arcspan_scene_limits limits{4, 4};
  std::vector<unsigned char> memory(arcspan_scene_bytes(&limits)), more(stage.memory.size() + 8);
  arcspan_scene* scene = nullptr;
  REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &limits, &scene) == ARCSPAN_OK);
  const auto add = [&](const void* binary, std::size_t size, std::size_t room, std::size_t offset = 0) {
    return arcspan_add_character(scene, binary, size, nullptr, more.data() + offset, room, &stage.character);
  };
  const std::size_t room = stage.memory.size();
  CHECK(add(bytes, kWalkerBytes - 1, room) == ARCSPAN_TRUNCATED);
  CHECK(add(bytes, 0, room) == ARCSPAN_TRUNCATED);
  CHECK(add(nullptr, kWalkerBytes, room) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_character_bytes(nullptr, kWalkerBytes) == 0);
  CHECK(add(bytes + 2, kWalkerBytes - 2, room) == ARCSPAN_INVALID_ARGUMENT);
  bytes[kWalkerBytes / 2] ^= 1;
  CHECK(add(bytes, kWalkerBytes, room) == ARCSPAN_CORRUPTED);
  CHECK(arcspan_character_bytes(bytes, kWalkerBytes) == 0);
  bytes[kWalkerBytes / 2] ^= 1;
  test::Rig rig = test::tube(3, 2, 30000, 4000, 1);
  rig.nodes[2].parent = 3;  // below it
  const auto damaged = rig.file();
  std::memcpy(bytes, damaged.data(), std::min(damaged.size(), kWalkerBytes));
  CHECK(add(bytes, damaged.size(), room) == ARCSPAN_CORRUPTED);
  CHECK(add(kWalker, kWalkerBytes, room - 1) == ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(arcspan_add_character(scene, kWalker, kWalkerBytes, nullptr, nullptr, room, &stage.character) ==
        ARCSPAN_BUFFER_TOO_SMALL);
  const arcspan_look gouraud{ARCSPAN_GOURAUD, 1, 0, nullptr, 0};
  CHECK(arcspan_add_character(scene, kWalker, kWalkerBytes, &gouraud, more.data(), room, &stage.character) ==
        ARCSPAN_UNSUPPORTED);
  const arcspan_look toon{ARCSPAN_ARC, 1, 0, nullptr, 3};
  CHECK(arcspan_add_character(scene, kWalker, kWalkerBytes, &toon, more.data(), room, &stage.character) ==
        ARCSPAN_UNSUPPORTED);
  CHECK(arcspan_add_binary(scene, kWalker, kWalkerBytes, &toon, nullptr) == ARCSPAN_UNSUPPORTED);
  const arcspan_view_limits nothing = arcspan_limits_of(scene, 1);
  CHECK((nothing.objects == 0 && nothing.vertices == 0 && arcspan_limits_of(scene, 0).vertices == 0));
  CHECK(stage.character == kept);
  CHECK(add(kWalker, kWalkerBytes, room, 1) == ARCSPAN_OK);                // at any address
  CHECK(add(kWalker, kWalkerBytes, room, 4) == ARCSPAN_BUFFER_TOO_SMALL);  // the scene is full

  CHECK(arcspan_play(kept, 2, 0, ARCSPAN_REPEAT) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_play(kept, ARCSPAN_NONE, 0, ARCSPAN_REPEAT) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_play(kept, 0, 0, 2) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_attach(kept, 14, stage.held) == ARCSPAN_INVALID_ARGUMENT);
  arcspan_point nowhere;
  CHECK(arcspan_node_position(kept, 14, &nowhere) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_attach(kept, 0, 99) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_attach(kept, 0, arcspan_object_of(kept)) == ARCSPAN_INVALID_ARGUMENT);
}

/// The vertices of the part of a rig, in C and by a mesh of C++.
template <class Mesh>
void check_vertices(const arcspan_character& character, const Mesh& expected, const MeshView& rest) {
  const auto& material =
      static_cast<const PosedMaterial<c::CharacterMesh>&>(*character.scene.objects->part(0).material);
  bool moves = false;
  for (std::size_t i = 0; i < rest.vertex_count(); ++i) {
    const ObjectPosition found = material.mesh().position(i);
    CHECK((found.x == expected.position(i).x && found.y == expected.position(i).y &&
           found.z == expected.position(i).z));
    const Direction normal = material.mesh().direction(i);
    CHECK((normal.x == expected.direction(i).x && normal.y == expected.direction(i).y &&
           normal.z == expected.direction(i).z));
    moves = moves || found.x != rest.position(i).x || found.y != rest.position(i).y;
  }
  CHECK(moves);
}

TEST_CASE("joints, morph targets and both move the vertices of a character") {
  for (const bool with_joints : {false, true}) {
    CAPTURE(with_joints);
    test::Rig rig = test::tube(3, 2, 30000, 4000, 1);
    rig.targets = 1;
    for (auto& vertex : rig.vertices) vertex.morphs = {{0, {1000, 700, -300}, {0.2, 0, 0}}};
    rig.clips.push_back(test::bending(rig, Interpolation::kLinear, 20));
    rig.clips[0].channels.push_back(
        {0, ChannelPath::kMorphWeights, Interpolation::kLinear, {0, 1'000'000}, {{0}, {1}}});
    auto chunks = rig.chunks();
    if (!with_joints) {
      chunks.erase(std::remove_if(chunks.begin(), chunks.end(),
                                  [](const auto& c) { return c.tag == "WGHT" || c.tag == "BNDS"; }),
                   chunks.end());
      const auto parts =
          std::find_if(chunks.begin(), chunks.end(), [](const auto& c) { return c.tag == "PART"; });
      parts->bytes.at(31) = 100;  // at rest a radius of 100 x 256
    }
    const auto file = test::file_of(chunks);
    const arcspan_scene_limits limits{1, 1};
    std::vector<unsigned char> memory(arcspan_scene_bytes(&limits));
    std::vector<unsigned char> of_character(arcspan_character_bytes(file.data(), file.size()));
    arcspan_scene* scene = nullptr;
    arcspan_character* character = nullptr;
    REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &limits, &scene) == ARCSPAN_OK);
    REQUIRE(arcspan_add_character(scene, file.data(), file.size(), nullptr, of_character.data(),
                                  of_character.size(), &character) == ARCSPAN_OK);
    REQUIRE(arcspan_play(character, 0, 0, ARCSPAN_STOP) == ARCSPAN_OK);
    arcspan_advance(character, 400'000);

    StoredModel model;
    StoredAnimation animation;
    REQUIRE(ok(view_model_binary(file, model)));
    REQUIRE(ok(view_animation(model, animation)));
    const ClipBlend blend{{animation.clip(0), 400'000}, {}, 0};
    NodeMatrix nodes[4];
    JointMatrix joints[3];
    std::int16_t weight = 0;
    const MeshView rest = model.part(0).mesh;
    MorphedMesh morphed;
    REQUIRE(ok(pose_nodes(animation, blend, nodes)));
    REQUIRE(ok(pose_joints(animation.skin(0), nodes, joints)));
    REQUIRE(ok(pose_morph(animation, 0, blend, {&weight, 1})));
    REQUIRE(ok(MorphedMesh::make(rest, animation, 0, {&weight, 1}, morphed)));
    if (!with_joints) {
      check_vertices(*character, morphed, rest);
      CHECK(scene->objects->sphere().radius > 50'000);
      continue;
    }
    MorphedSkinnedMesh both;
    REQUIRE(ok(MorphedSkinnedMesh::make(morphed, animation, 0, joints, both)));
    check_vertices(*character, both, rest);
  }
}

}  // namespace
