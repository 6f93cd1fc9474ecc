// SPDX-License-Identifier: MIT
// Skinned vertices of generated rigs against the same in double precision.
#include <arcspan/animate/attachment.hpp>
#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/posed_bound.hpp>
#include <arcspan/animate/skinned_mesh.hpp>

#include <catch2/catch.hpp>
#include <tests/support/animated_rig.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// A rig as the pipeline sees it, and its memory.
struct Shown {
  explicit Shown(const Rig& rig) : file(rig.file()) {
    REQUIRE(view_model_binary(file, model) == Status::kOk);
    REQUIRE(view_animation(model, animation) == Status::kOk);
    part = model.part(0);
    nodes.resize(animation.nodes().size());
    joints.resize(animation.skin(0).size());
    REQUIRE(ok(SkinnedMesh::make(part.mesh, animation, 0, joints, mesh)));
  }
  void pose(const ClipBlend& blend) {
    REQUIRE(ok(pose_nodes(animation, blend, nodes)));
    REQUIRE(ok(pose_joints(animation.skin(0), nodes, joints)));
  }

  Bytes file;
  StoredModel model;
  StoredAnimation animation;
  ModelPart part;
  std::vector<NodeMatrix> nodes;
  std::vector<JointMatrix> joints;
  SkinnedMesh mesh;
};

/// Largest errors of all vertices: positions in object units, normals in degrees and in length.
struct Errors {
  double position = 0;
  double normal = 0;
  double length = 0;
};

void include(const Rig::Placed& truth, ObjectPosition p, Direction n, Errors& errors) {
  const Vec3 off = Vec3{double(p.x), double(p.y), double(p.z)} - truth.position;
  errors.position = std::max(errors.position, length(off));
  errors.normal = std::max(errors.normal, degrees(angle_between(to_vec3(n), truth.normal)));
  errors.length = std::max(errors.length, std::abs(length(to_vec3(n)) - 1));
}

void compare(const Rig& rig, const Shown& shown, const std::vector<Affine>& pose, Errors& errors) {
  for (std::size_t i = 0; i < rig.vertices.size(); ++i)
    include(rig.placed(i, pose, {}), shown.mesh.position(i), shown.mesh.direction(i), errors);
}

constexpr double kLength = 40000;

void check_errors(const Rig& rig) {
  Shown shown(rig);
  Errors errors;
  for (std::uint32_t time = 0; time <= 2'000'000; time += 41'667) {
    shown.pose({{shown.animation.clip(0), time}, {}, 0});
    compare(rig, shown, rig.pose(0, time), errors);
  }
  INFO("position " << errors.position << " object units, normal " << errors.normal << " degrees");
  CHECK(errors.position < kLength / 4096);
  CHECK(errors.normal < 0.12);
  CHECK(errors.length < 0x1p-12);
}

}  // namespace

TEST_CASE("at rest a mesh lies where it was bound") {
  const Rig rig = tube(5, 4, kLength, 4000, 1);
  Shown shown(rig);
  shown.pose({});
  for (std::size_t i = 0; i < rig.vertices.size(); ++i) {
    const ObjectPosition p = shown.mesh.position(i);
    const Vec3 off = Vec3{double(p.x), double(p.y), double(p.z)} - rig.vertices[i].position;
    CHECK(length(off) < 4);
    CHECK(degrees(angle_between(to_vec3(shown.mesh.direction(i)), rig.vertices[i].normal)) < 0.03);
  }
}

TEST_CASE("a bending tube is within 1/4096 of its extent of double precision") {
  for (const int influences : {1, 2, 3, 4}) {
    for (const Interpolation kind : {Interpolation::kStep, Interpolation::kLinear, Interpolation::kCubic}) {
      CAPTURE(influences, static_cast<int>(kind));
      Rig rig = tube(6, influences, kLength, 4000, 1);
      rig.clips.push_back(bending(rig, kind, 25));
      check_errors(rig);
    }
  }
}

TEST_CASE("a skin that is bound in another unit, below a node that is moved and scaled, is as exact") {
  for (const double scale : {0.25, 3.0, 20.0}) {
    CAPTURE(scale);
    Rig rig = tube(6, 4, kLength, 4000, scale);
    rig.clips.push_back(bending(rig, Interpolation::kLinear, 25));
    check_errors(rig);
  }
}

TEST_CASE("joints may be scaled and moved by keys") {
  Rig rig = tube(4, 3, 20000, 3000, 1);
  RigClip clip{"grow", 2'000'000, {}};
  for (int node = 1; node <= 4; ++node) {
    const Vec3 at = rig.nodes[static_cast<std::size_t>(node)].translation;
    clip.channels.push_back({node,
                             ChannelPath::kTranslation,
                             Interpolation::kCubic,
                             {0, 700'000, 2'000'000},
                             {{0, 0, 0},
                              {at.x, at.y, at.z},
                              {300, 0, 900},
                              {0, 700, 0},
                              {at.x + 500, at.y, at.z - 800},
                              {0, -700, 100},
                              {10, 20, 30},
                              {at.x, at.y + 1000, at.z},
                              {0, 0, 0}}});
    clip.channels.push_back({node,
                             ChannelPath::kScale,
                             Interpolation::kLinear,
                             {100'000, 1'000'000, 1'500'000},
                             {{1, 1, 1}, {1.3, 1.3, 1.3}, {0.5, 0.5, 0.5}}});
  }
  rig.clips.push_back(clip);
  check_errors(rig);
}

TEST_CASE("a joint may be up to 16 times as large as it was bound") {
  for (const double scale : {5.0, 15.9}) {
    CAPTURE(scale);
    Rig rig = tube(2, 2, 30000 / scale, 6000 / scale, 1);
    rig.clips.push_back(
        {"large", 2'000'000, {{1, ChannelPath::kScale, Interpolation::kStep, {0}, {{scale, scale, scale}}}}});
    check_errors(rig);
  }
}

TEST_CASE("positions out of range are saturated") {
  Rig rig = tube(2, 2, 40000, 1000, 1);
  rig.clips.push_back(
      {"out", 2'000'000, {{1, ChannelPath::kScale, Interpolation::kStep, {0}, {{2.5, 2.5, 2.5}}}}});
  Shown shown(rig);
  shown.pose({{shown.animation.clip(0), 0}, {}, 0});
  const ObjectPosition p = shown.mesh.position(rig.vertices.size() - 1);
  CHECK(p.y == 32767);
}

TEST_CASE("a clip of an hour of turns ends as exactly as it begins") {
  // Poses are computed from keys, each anew: nothing adds up.
  Rig rig = tube(6, 4, kLength, 4000, 1);
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 25));
  Shown shown(rig);
  ClipPlayer player(shown.animation.clip(0));
  player.advance(123'456);
  shown.pose(player.blend());
  std::vector<ObjectPosition> before;
  for (std::size_t i = 0; i < rig.vertices.size(); ++i) before.push_back(shown.mesh.position(i));
  for (int i = 0; i < 200'000; ++i) player.advance(20'000);
  CHECK(player.time() == 123'456);
  shown.pose(player.blend());
  for (std::size_t i = 0; i < rig.vertices.size(); ++i) CHECK(shown.mesh.position(i) == before[i]);
}

TEST_CASE("half-way between two clips a joint is half-way between their poses") {
  Rig rig = tube(2, 1, 20000, 1000, 1);
  const Quat rest = rig.nodes[1].rotation;
  const auto turned = [&](double turn) {
    // About the axis that the joint is turned back by, so that angles add up.
    const Quat q = about({1, 2, 3}, -40 + turn);
    return std::vector<double>{q[0], q[1], q[2], q[3]};
  };
  CHECK(rest[3] == Approx(turned(0)[3]));
  rig.clips.push_back({"a", 1000, {{1, ChannelPath::kRotation, Interpolation::kStep, {0}, {turned(10)}}}});
  rig.clips.push_back({"b", 1000, {{1, ChannelPath::kRotation, Interpolation::kStep, {0}, {turned(50)}}}});
  rig.clips.push_back({"ab", 1000, {{1, ChannelPath::kRotation, Interpolation::kStep, {0}, {turned(30)}}}});
  Shown shown(rig);
  shown.pose({{shown.animation.clip(0), 0}, {shown.animation.clip(1), 0}, 32768});
  Errors errors;
  compare(rig, shown, rig.pose(2, 0), errors);
  CHECK(errors.position < 4);
  CHECK(errors.normal < 0.03);
}

TEST_CASE("too little memory for a pose is refused, and nothing is written") {
  Rig rig = tube(3, 2, 20000, 1000, 1);
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 25));
  Shown shown(rig);
  CHECK(pose_nodes(shown.animation, {}, std::span(shown.nodes).first(3)) == Status::kBufferTooSmall);
  CHECK(pose_joints(shown.animation.skin(0), shown.nodes, std::span(shown.joints).first(2)) ==
        Status::kBufferTooSmall);
  CHECK(pose_joints(shown.animation.skin(0), std::span(shown.nodes).first(3), shown.joints) ==
        Status::kIndexOutOfRange);
  SkinnedMesh mesh;
  CHECK(SkinnedMesh::make(shown.part.mesh, shown.animation, 0, std::span(shown.joints).first(2), mesh) ==
        Status::kBufferTooSmall);
  CHECK(SkinnedMesh::make(shown.part.mesh, shown.animation, 1, shown.joints, mesh) ==
        Status::kInvalidArgument);
  CHECK(mesh.view().vertex_count() == 0);
}

TEST_CASE("morph targets move vertices and normals, before joints do") {
  Rig rig = tube(4, 3, 20000, 3000, 1);
  rig.targets = 3;
  Random random(47);
  for (RigVertex& vertex : rig.vertices) {
    for (int target = 0; target < 3; ++target) {
      if (random.chance(0.5)) continue;
      const Vec3 by = 1500 * random_unit(random);
      vertex.morphs.push_back(
          {target, {std::round(by.x), std::round(by.y), std::round(by.z)}, 0.4 * random_unit(random)});
    }
  }
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 25));
  rig.clips[0].channels.push_back({0,
                                   ChannelPath::kMorphWeights,
                                   Interpolation::kCubic,
                                   {0, 900'000, 2'000'000},
                                   {{0, 0, 0},
                                    {0, 0.5, 1},
                                    {1, 0, 0},
                                    {0, 0, 0.5},
                                    {1, 0.25, -0.5},
                                    {0.5, 1, 0},
                                    {0, 0, 0},
                                    {0, 1, 1.5},
                                    {0, 0, 0}}});
  Shown shown(rig);
  std::int16_t weights[3];
  CHECK(pose_morph(shown.animation, 0, {}, std::span(weights).first(2)) == Status::kBufferTooSmall);
  MorphedMesh morphed;
  CHECK(MorphedMesh::make(shown.part.mesh, shown.animation, 0, std::span(weights).first(2), morphed) ==
        Status::kBufferTooSmall);
  REQUIRE(ok(MorphedMesh::make(shown.part.mesh, shown.animation, 0, weights, morphed)));
  MorphedSkinnedMesh mesh;
  REQUIRE(ok(MorphedSkinnedMesh::make(morphed, shown.animation, 0, shown.joints, mesh)));
  Errors errors;
  for (std::uint32_t time = 0; time <= 2'000'000; time += 83'333) {
    const ClipBlend blend{{shown.animation.clip(0), time}, {}, 0};
    shown.pose(blend);
    REQUIRE(ok(pose_morph(shown.animation, 0, blend, weights)));
    const std::vector<Affine> pose = rig.pose(0, time);
    const std::vector<double> morph = rig.morph(0, time);
    for (std::size_t i = 0; i < rig.vertices.size(); ++i)
      include(rig.placed(i, pose, morph), mesh.position(i), mesh.direction(i), errors);
  }
  INFO("position " << errors.position << " object units, normal " << errors.normal << " degrees");
  CHECK(errors.position < 20000.0 / 4096);
  CHECK(errors.normal < 0.12);
  CHECK(errors.length < 0x1p-12);
}

TEST_CASE("between two clips morph weights are between theirs, or those at rest") {
  Rig rig = tube(2, 1, 20000, 3000, 1);
  rig.targets = 1;
  rig.vertices[0].morphs = {{0, {1000, 0, 0}, {0, 0, 0}}};
  rig.clips.push_back({"a", 1000, {{0, ChannelPath::kMorphWeights, Interpolation::kStep, {0}, {{1}}}}});
  rig.clips.push_back({"b", 1000, {{1, ChannelPath::kScale, Interpolation::kStep, {0}, {{1, 1, 1}}}}});
  Shown shown(rig);
  std::int16_t weight = 0;
  const ClipMoment a{shown.animation.clip(0), 0};
  const ClipMoment b{shown.animation.clip(1), 0};
  REQUIRE(ok(pose_morph(shown.animation, 0, {a, b, 16384}, std::span(&weight, 1))));
  CHECK(weight == 3072);
  REQUIRE(ok(pose_morph(shown.animation, 0, {b, a, 16384}, std::span(&weight, 1))));
  CHECK(weight == 1024);
}

TEST_CASE("a mesh without morph targets is no morphed one") {
  const Rig rig = tube(2, 1, 20000, 3000, 1);
  const Shown shown(rig);
  MorphedMesh morphed;
  CHECK(MorphedMesh::make(shown.part.mesh, shown.animation, 0, {}, morphed) == Status::kInvalidArgument);
  CHECK(morphed.view().vertex_count() == 0);
}

TEST_CASE("a whole mesh may follow one joint") {
  Rig rig = tube(3, 1, kLength, 4000, 1);
  rig.follows_joint = 1;
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 25));
  check_errors(rig);
}

TEST_CASE("the bound of a pose holds all vertices, and is not much larger than the bounds of its joints") {
  Rig rig = tube(6, 4, kLength, 4000, 1);
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 60));
  Shown shown(rig);
  const std::span<const JointBound> bounds = shown.animation.bounds(0);
  for (std::uint32_t time = 0; time <= 2'000'000; time += 125'000) {
    shown.pose({{shown.animation.clip(0), time}, {}, 0});
    const BoundingSphere sphere = posed_bound(bounds, shown.joints);
    const Vec3 middle{double(sphere.middle.x), double(sphere.middle.y), double(sphere.middle.z)};
    double farthest = 0;
    for (std::size_t i = 0; i < rig.vertices.size(); ++i) {
      const ObjectPosition p = shown.mesh.position(i);
      farthest = std::max(farthest, length(Vec3{double(p.x), double(p.y), double(p.z)} - middle));
    }
    CHECK(farthest <= sphere.radius);
    CHECK(sphere.radius < farthest + 24000);  // a sphere of a joint has a radius of up to 13,000
  }
  CHECK(posed_bound({}, shown.joints).radius == 56756);
  CHECK(posed_bound(bounds, std::span(shown.joints).first(5)).radius == 56756);
}

TEST_CASE("an object is held where its node is, whatever the scale of the node") {
  Rig rig = tube(4, 2, 20000, 3000, 1);
  rig.nodes[2].scale = {1.5, 1.5, 1.5};
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 40));
  Shown shown(rig);
  shown.pose({{shown.animation.clip(0), 300'000}, {}, 0});
  Placement body{Rotation::about_y({9000}), {}};
  body.translation[0] = ObjectLength::of(100);
  body.translation[2] = ObjectLength::of(-90000);
  const Affine view = affine({100, 0, -90000}, about({0, 1, 0}, 9000 * 360.0 / 65536), {1, 1, 1});
  const Affine node = view * rig.pose(0, 300'000)[3];
  const Placement held = attached(body, shown.nodes[3]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double translations[3] = {node.t.x, node.t.y, node.t.z};
    CHECK(held.translation[i].raw() / 256.0 == Approx(translations[i]).margin(4));
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(std::ldexp(held.rotation.m[i][j].raw(), -30) == Approx(node.m[i][j] / 1.5).margin(0.001));
  }
  const Placement still = attached(body, {});
  CHECK(still.translation[2] == ObjectLength::of(-90000));
  CHECK(std::abs(still.rotation.m[0][0].raw() - body.rotation.m[0][0].raw()) < 4);
}
