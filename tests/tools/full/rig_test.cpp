// SPDX-License-Identifier: MIT
// Skins, morph targets and clips of glTF: posed in doubles, stored in fixed point, and posed by the pipeline.
#include <arcspan/animate/morphed_mesh.hpp>
#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/posed_bound.hpp>
#include <arcspan/animate/skinned_mesh.hpp>

#include <arcspan_tools/command/runtime_model.hpp>
#include <arcspan_tools/fixed_point/stored_pose.hpp>
#include <arcspan_tools/mesh/compile/animation_error.hpp>
#include <arcspan_tools/mesh/compile/compile_mesh.hpp>
#include <arcspan_tools/mesh/compile/make_animation.hpp>
#include <arcspan_tools/mesh/compile/mirroring_clips.hpp>
#include <arcspan_tools/mesh/compile/part_motion.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/compile/thin_keys.hpp>
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/gltf_rig.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <numeric>
#include <set>

using namespace arcspan::tools;
using namespace arcspan::test;
using nlohmann::json;

namespace {

using Lines = std::vector<std::string>;

Model loaded(const GltfRig& rig) {
  const TemporaryFolder folder;
  return load_model_file(folder.file("rig.glb", rig.glb()));
}

std::string complaint(const GltfRig& rig) {
  const TemporaryFolder folder;
  const std::string path = folder.file("rig.glb", rig.glb());
  const std::string message = message_of<Failure>([&] { (void)load_model_file(path); });
  return message.rfind(path + ": ", 0) == 0 ? message.substr(path.size() + 2)
                                            : "(without the name) " + message;
}

Model posed_at(const Model& model, std::size_t clip, double time) {
  return posed(model, pose_at(*model.rig, model.rig->clips.at(clip), time), "rig");
}

std::vector<Vec3> normals_at(const Model& model, double time) {
  return posed_at(model, 0, time).parts[0].mesh.normals;
}

/// Where the vertex is that a rig stores at `stored`.
Vec3 where(const Model& model, Vec3 stored, const RigPose& pose) {
  const RigPoser poser(*model.rig, pose);
  for (const RigVertex& vertex : model.rig->vertices) {
    if (length(vertex.position - stored) < 1e-6) return poser.position(vertex);
  }
  FAIL("no vertex is stored there");
  return {};
}

/// The tube bends by 90 degrees in a second and back in another.
GltfRig bending() {
  GltfRig rig = bending_tube();
  rig.clip("bend");
  rig.channel(2, "rotation", {0, .5f, 1, 2},
              rig.quadruples(joined({turn_z(0), turn_z(45), turn_z(90), turn_z(0)})));
  return rig;
}

/// The tube with a morph target that pulls all its vertices 2 along x.
GltfRig stretching_tube() {
  GltfRig rig = bending_tube();
  Floats pull;
  for (int i = 0; i < 36; ++i) pull.insert(pull.end(), {2, 0, 0});
  rig.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", rig.vectors(pull)}}};
  return rig;
}

/// A chain of so many joints from the first one up, half a unit apart, with a square at each. All turn by
/// `degrees` in a second.
GltfRig curling_chain(std::size_t joints, double degrees) {
  GltfRig rig;
  Floats positions;
  Floats weights;
  std::vector<std::uint8_t> numbers;
  std::vector<std::uint16_t> indices;
  Floats bind;
  rig.json["nodes"] = json::parse(R"([{"mesh": 0, "skin": 0}])");
  rig.clip("curl");
  for (std::size_t i = 0; i < joints; ++i) {
    const float y = static_cast<float>(i) / 2;
    const auto first = static_cast<std::uint16_t>(4 * i);
    for (const Floats& p : {Floats{0, y, 0}, {.2f, y, 0}, {.2f, y + .5f, 0}, {0, y + .5f, 0}}) {
      positions.insert(positions.end(), p.begin(), p.end());
      weights.insert(weights.end(), {1, 0, 0, 0});
      numbers.insert(numbers.end(), {static_cast<std::uint8_t>(i), 0, 0, 0});
    }
    for (const int k : {0, 1, 2, 0, 2, 3}) indices.push_back(static_cast<std::uint16_t>(first + k));
    bind.insert(bind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -y, 0, 1});
    rig.json["nodes"].push_back({{"translation", {0, i == 0 ? 0 : .5, 0}}});
    rig.json["nodes"][i]["children"] = {i + 1};
    rig.json["skins"][0]["joints"].push_back(i + 1);
    rig.channel(static_cast<int>(i) + 1, "rotation", {0, 1},
                rig.quadruples(joined({turn_z(0), turn_z(degrees)})));
  }
  rig.json["skins"][0]["inverseBindMatrices"] = rig.accessor("MAT4", 16, bind);
  rig.json["meshes"] = {{{"primitives",
                          {{{"attributes",
                             {{"POSITION", rig.vectors(positions)},
                              {"JOINTS_0", rig.accessor("VEC4", 4, numbers)},
                              {"WEIGHTS_0", rig.quadruples(weights)}}},
                            {"indices", rig.accessor("SCALAR", 1, indices)}}}}}};
  return rig;
}

/// A square of one node whose clip has one channel.
GltfRig moved_square(const char* path, const Floats& times, const Floats& values, const char* interpolation) {
  GltfRig rig;
  rig.json["nodes"] = json::parse(R"([{"mesh": 0}])");
  rig.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", rig.vectors({0, 0, 0, 1, 0, 0, 1, 1, 0})}}}}}}}};
  rig.clip("move");
  const bool rotates = std::string(path) == "rotation";
  rig.channel(0, path, times, rotates ? rig.quadruples(values) : rig.vectors(values), interpolation);
  return rig;
}

FixedModel stored(const Model& model, const ClipOptions& options = {}) {
  FixedModel fixed =
      compile_model(
          as_stored(model), {}, [](const FixedModel&) { return std::size_t{0}; }, "rig", [](std::size_t) {})
          .model;
  fixed.animation = std::make_shared<FixedAnimation>(make_animation(fixed, options, "rig"));
  return fixed;
}

/// A model binary at an aligned address.
struct Binary {
  std::vector<std::uint32_t> words;
  arcspan::StoredModel model;
  arcspan::StoredAnimation animation;

  explicit Binary(const FixedModel& fixed) {
    const std::string text = model_binary_file(fixed);
    words.resize((text.size() + 3) / 4);
    std::memcpy(words.data(), text.data(), text.size());
    REQUIRE(arcspan::view_model_binary({reinterpret_cast<const std::uint8_t*>(words.data()), text.size()},
                                       model) == arcspan::Status::kOk);
    REQUIRE(arcspan::view_animation(model, animation) == arcspan::Status::kOk);
  }
};

struct PosedVertex {
  arcspan::ObjectPosition position;
  arcspan::Direction direction;
};

template <class Mesh>
std::vector<PosedVertex> vertices_of(const Mesh& mesh) {
  std::vector<PosedVertex> vertices;
  for (std::size_t i = 0; i < mesh.view().vertex_count(); ++i)
    vertices.push_back({mesh.position(i), mesh.direction(i)});
  return vertices;
}

template <class Mesh>
std::vector<PosedVertex> skinned_vertices(const Mesh& mesh, const Binary& binary, std::size_t part,
                                          std::span<const arcspan::JointMatrix> joints) {
  arcspan::BasicSkinnedMesh<Mesh> skinned;
  REQUIRE(ok(arcspan::BasicSkinnedMesh<Mesh>::make(mesh, binary.animation, part, joints, skinned)));
  return vertices_of(skinned);
}

/// A part that follows joints as the pipeline poses it. Requires that its bound holds it.
std::vector<PosedVertex> posed_by_pipeline(const Binary& binary, std::size_t part,
                                           const arcspan::ClipBlend& blend) {
  const arcspan::StoredAnimation& animation = binary.animation;
  std::vector<arcspan::NodeMatrix> nodes(animation.nodes().size());
  REQUIRE(ok(arcspan::pose_nodes(animation, blend, nodes)));
  const auto skin = animation.skin(animation.weights(part).skin());
  std::vector<arcspan::JointMatrix> joints(skin.size());
  REQUIRE(ok(arcspan::pose_joints(skin, nodes, joints)));
  const arcspan::MeshView mesh = binary.model.part(part).mesh;
  std::vector<PosedVertex> vertices;
  if (animation.morph(part).target_count() == 0) {
    vertices = skinned_vertices(mesh, binary, part, joints);
  } else {
    std::vector<std::int16_t> weights(animation.morph(part).target_count());
    REQUIRE(ok(arcspan::pose_morph(animation, part, blend, weights)));
    arcspan::MorphedMesh morphed;
    REQUIRE(ok(arcspan::MorphedMesh::make(mesh, animation, part, weights, morphed)));
    vertices = skinned_vertices(morphed, binary, part, joints);
  }
  const arcspan::BoundingSphere bound = arcspan::posed_bound(animation.bounds(part), joints);
  for (const PosedVertex& v : vertices) {
    const Vec3 away{double(v.position.x - bound.middle.x), double(v.position.y - bound.middle.y),
                    double(v.position.z - bound.middle.z)};
    REQUIRE(length(away) <= bound.radius + 2);
  }
  return vertices;
}

/// The largest distance of a vertex that the pipeline poses from where doubles put the file's, in object
/// units.
double worst_of_pipeline(const FixedModel& fixed, std::size_t clip, double time) {
  const Binary binary(fixed);
  const arcspan::ClipMoment moment{binary.animation.clip(clip), static_cast<std::uint32_t>(time * 1e6)};
  const RigPoser poser(*fixed.rig, pose_at(*fixed.rig, fixed.rig->clips.at(clip), time));
  double worst = 0;
  for (std::size_t part = 0; part < fixed.meshes.size(); ++part) {
    const FixedMesh& mesh = fixed.meshes[part];
    const std::vector<PosedVertex> posed = posed_by_pipeline(binary, part, {moment, {}, 0});
    for (std::size_t i = 0; i < mesh.sources.size(); ++i) {
      const arcspan::ObjectPosition& p = posed[i].position;
      const Vec3 right =
          (poser.position(fixed.rig->vertices[mesh.sources[i]]) - mesh.centre) * (1 / mesh.unit);
      worst = std::max(worst, length(Vec3{double(p.x), double(p.y), double(p.z)} - right));
    }
  }
  return worst;
}

/// A mesh at node 0 with one morph target, whose weight the clip "open" takes from 0 to 1.
GltfRig morphed(const Floats& base, const Floats& added) {
  GltfRig rig;
  rig.json["nodes"] = json::parse(R"([{"mesh": 0}])");
  rig.json["meshes"] = {{{"primitives",
                          {{{"attributes", {{"POSITION", rig.vectors(base)}}},
                            {"targets", {{{"POSITION", rig.vectors(added)}}}}}}}}};
  rig.clip("open");
  rig.channel(0, "weights", {0, 1}, rig.scalars({0, 1}));
  return rig;
}

std::size_t triangles_of(const FixedModel& model) {
  std::size_t indices = 0;
  for (const FixedMesh& mesh : model.meshes) indices += mesh.indices.size();
  return indices / 3;
}

/// The least cosine between the front of a triangle and the normals of its corners.
double least_cosine(const MeshData& mesh) {
  double least = 1;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 front = normalised(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    for (const std::uint32_t corner : t) least = std::min(least, dot(front, mesh.normals[corner]));
  }
  return least;
}

RigChannel turning(std::size_t keys, double degrees) {
  RigChannel channel;
  channel.path = ChannelPath::kRotation;
  channel.components = 4;
  for (std::size_t i = 0; i < keys; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(keys - 1);
    channel.times.push_back(t);
    for (const float c : turn_z(degrees * std::sin(t * 3))) channel.values.push_back(c);
  }
  return channel;
}

double degrees_apart(const std::vector<double>& a, const std::vector<double>& b) {
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double size = std::sqrt((a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]) *
                                (b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + b[3] * b[3]));
  return 2 * std::acos(std::min(std::abs(cosine) / size, 1.0)) / kDegree;
}

/// The largest angle in degrees, in a second, between rotations of a channel by their components, as the
/// pipeline plays them, and those of another channel by arcs.
double played_apart(const RigChannel& played, const RigChannel& exact) {
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double time = i / 1000.;
    const auto next = std::upper_bound(played.times.begin(), played.times.end() - 1, time);
    const auto key = static_cast<std::size_t>(next - played.times.begin()) - 1;
    const double t = (time - played.times[key]) / (played.times[key + 1] - played.times[key]);
    std::vector<double> mixed(4);
    for (std::size_t k = 0; k < 4; ++k)
      mixed[k] = played.value(key)[k] * (1 - t) + played.value(key + 1)[k] * t;
    worst = std::max(worst, degrees_apart(mixed, exact.at(time)));
  }
  return worst;
}

}  // namespace

TEST_CASE("rigs: a tube bends at its joint, wherever the node of its mesh is") {
  const Model model = loaded(bending());
  CHECK(model.warnings.empty());
  REQUIRE(model.rig->clips.size() == 1);
  CHECK(model.rig->clips[0].name == "bend");
  CHECK(model.rig->clips[0].duration() == 2);
  const RigPose bent = pose_at(*model.rig, model.rig->clips[0], 1);
  const RigPose half = pose_at(*model.rig, model.rig->clips[0], 0.25);
  // The upper end turns about (0, 1); the lower end stays.
  CHECK(length(where(model, {.2f, 2, .2f}, bent) - Vec3{-1, 1.2, .2}) < 1e-6);
  CHECK(length(where(model, {.2f, 0, .2f}, bent) - Vec3{.2, 0, .2}) < 1e-6);
  const double s = std::sin(22.5 * kDegree);
  const double c = std::cos(22.5 * kDegree);
  CHECK(length(where(model, {.2f, 2, .2f}, half) - Vec3{.2 * c - s, 1 + .2 * s + c, .2}) < 1e-6);
  // In the middle half of each: (.2, 1) and (0, 1.2).
  CHECK(length(where(model, {.2f, 1, .2f}, bent) - Vec3{.1, 1.1, .2}) < 1e-6);
}

TEST_CASE("rigs: a posed model has the vertices, triangles and turned normals of the model at rest") {
  const Model model = loaded(bending());
  const Model bent = posed_at(model, 0, 1);
  CHECK(bent.rig == nullptr);
  REQUIRE(bent.parts.size() == 1);
  CHECK(bent.parts[0].mesh.triangles == model.parts[0].mesh.triangles);
  CHECK(bent.parts[0].mesh.sources.empty());
  std::size_t turned = 0;
  for (std::size_t i = 0; i < model.parts[0].mesh.positions.size(); ++i) {
    if (model.parts[0].mesh.positions[i].y < 1.9) continue;
    const Vec3 n = model.parts[0].mesh.normals[i];
    CHECK(length(bent.parts[0].mesh.normals[i] - Vec3{-n.y, n.x, n.z}) < 1e-6);
    ++turned;
  }
  CHECK(turned == 4);
  CHECK(posed(model, rest_pose(*model.rig), "rig").parts[0].mesh.positions == model.parts[0].mesh.positions);
}

TEST_CASE("rigs: linear, step and cubic keys, before the first and after the last") {
  const auto x = [](const GltfRig& rig, double time) {
    const Model model = loaded(rig);
    return where(model, {0, 0, 0}, pose_at(*model.rig, model.rig->clips[0], time)).x;
  };
  const Floats times = {1, 2};
  const GltfRig linear = moved_square("translation", times, {0, 0, 0, 4, 0, 0}, "LINEAR");
  CHECK(x(linear, 0) == 0);
  CHECK(x(linear, 1.25) == 1);
  CHECK(x(linear, 9) == 4);
  const GltfRig step = moved_square("translation", times, {0, 0, 0, 4, 0, 0}, "STEP");
  CHECK(x(step, 1.99) == 0);
  CHECK(x(step, 2) == 4);
  // in, value, out of each key: leaves at 2 per second, arrives at 8 per second.
  const GltfRig cubic = moved_square("translation", times,
                                     {9, 9, 9, 0, 0, 0, 2, 0, 0, 8, 0, 0, 4, 0, 0, 9, 9, 9}, "CUBICSPLINE");
  CHECK(x(cubic, 1) == 0);
  CHECK(x(cubic, 1.5) == Approx(2 + 2. / 8 - 8. / 8));
  CHECK(x(cubic, 2) == 4);
}

TEST_CASE("rigs: rotations take the shorter way") {
  Floats other = turn_z(40);
  for (float& c : other) c = -c;
  const Model model = loaded(moved_square("rotation", {0, 1}, joined({turn_z(0), other}), "LINEAR"));
  const Vec3 p = where(model, {1, 0, 0}, pose_at(*model.rig, model.rig->clips[0], 0.25));
  CHECK(length(p - Vec3{std::cos(10 * kDegree), std::sin(10 * kDegree), 0}) < 1e-6);
}

TEST_CASE("rigs: of eight weights the four largest are kept, and their sum is 1") {
  GltfRig rig = bending();
  json& primitive = rig.json["meshes"][0]["primitives"][0];
  const std::size_t vertices = 36;
  Floats first;
  Floats second;
  std::vector<std::uint8_t> joints;
  for (std::size_t i = 0; i < vertices; ++i) {
    for (const float w : {.1f, .05f, .3f, .2f}) first.push_back(w);
    for (const float w : {.15f, .1f, .06f, .04f}) second.push_back(w);
    for (const int j : {0, 1, 2, 3}) joints.push_back(static_cast<std::uint8_t>(j));
  }
  rig.json["nodes"] = json::parse(
      R"([{"mesh": 0, "skin": 0, "children": [1, 2, 3, 4, 5, 6, 7, 8]}, {}, {}, {}, {}, {}, {}, {}, {}])");
  rig.json["skins"][0] = {{"joints", {1, 2, 3, 4, 5, 6, 7, 8}}};
  std::vector<std::uint8_t> others = joints;
  for (std::uint8_t& j : others) j = static_cast<std::uint8_t>(j + 4);
  primitive["attributes"]["JOINTS_0"] = rig.accessor("VEC4", 4, joints);
  primitive["attributes"]["WEIGHTS_0"] = rig.quadruples(first);
  primitive["attributes"]["JOINTS_1"] = rig.accessor("VEC4", 4, others);
  primitive["attributes"]["WEIGHTS_1"] = rig.quadruples(second);
  const Model model = loaded(rig);
  const RigVertex& vertex = model.rig->vertices[0];
  CHECK(vertex.joints == std::array<std::size_t, 4>{2, 3, 4, 0});
  CHECK(vertex.weights[0] == Approx(.4));
  CHECK(std::accumulate(vertex.weights.begin(), vertex.weights.end(), 0.0) == Approx(1));
  CHECK(model.warnings == Lines{"left out: weights above four for a vertex (36)"});
}

TEST_CASE("rigs: morph targets with normals, at the weights of the file and of a clip") {
  GltfRig rig;
  rig.json["nodes"] = json::parse(R"([{"mesh": 0}])");
  rig.json["meshes"] = {{{"weights", {0.5}},
                         {"primitives",
                          {{{"attributes",
                             {{"POSITION", rig.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0})},
                              {"NORMAL", rig.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1})}}},
                            {"targets",
                             {{{"POSITION", rig.vectors({0, 0, 2, 0, 0, 0, 0, 0, 0})},
                               {"NORMAL", rig.vectors({1, 0, 0, 0, 0, 0, 0, 0, 0})}}}}}}}}};
  rig.clip("swell");
  rig.channel(0, "weights", {0, 1}, rig.scalars({0, 1}));
  const Model model = loaded(rig);
  const auto z = [&](const Model& m) {
    double most = 0;
    for (const Vec3& p : m.parts[0].mesh.positions) most = std::max(most, p.z);
    return most;
  };
  CHECK(z(model) == 1);
  CHECK(z(posed_at(model, 0, 0)) == 0);
  const Model whole = posed_at(model, 0, 1);
  CHECK(z(whole) == 2);
  const std::vector<Vec3>& normals = whole.parts[0].mesh.normals;
  CHECK(std::any_of(normals.begin(), normals.end(), [](Vec3 n) {
    return length(n - normalised(Vec3{1, 0, 1})) < 1e-6;
  }));
  const FixedModel fixed = stored(model);
  REQUIRE(fixed.animation->parts[0].morph);
  CHECK(fixed.animation->parts[0].weights.empty());  // no node moves it
  CHECK(fixed.animation->parts[0].morph->weights == std::vector<std::int16_t>{2048});
  CHECK(fixed.animation->parts[0].morph->has_normals);
  const AnimationError error = animation_error(fixed);
  CHECK(error.position < 2);
  CHECK(error.normal_degrees < 0.05);
  const Binary binary(fixed);
  CHECK(binary.animation.morph(0).target_count() == 1);
  CHECK(binary.animation.clip(0).channels().size() == 1);
  const RuntimeModel in_integers(model, "rig");
  CHECK(z(posed_like(model, in_integers.posed("", 0))) == Approx(1).margin(1e-3));
  CHECK(z(posed_like(model, in_integers.posed("swell", 1))) == Approx(2).margin(1e-3));
}

TEST_CASE("rigs: primitives of a mesh with different numbers of morph targets are refused") {
  GltfRig rig = morphed({0, 0, 0, 1, 0, 0, 1, 1, 0}, Floats(9));
  json& primitives = rig.json["meshes"][0]["primitives"];
  const json targets = {primitives[0]["targets"][0], primitives[0]["targets"][0]};
  primitives.push_back(primitives[0]);
  primitives[1]["targets"] = targets;
  CHECK(complaint(rig).find("another number of morph targets than the first primitive") != std::string::npos);
}

TEST_CASE("rigs: what is wrong with an animation leaves it out, with the place") {
  const auto warning = [](const char* pointer, const json& value) {
    GltfRig rig = bending();
    rig.json[json::json_pointer(pointer)] = value;
    const Lines lines = loaded(rig).warnings;
    return lines.size() == 1 ? lines[0] : "(" + std::to_string(lines.size()) + " warnings)";
  };
  const std::string begin = "an animation is left out: animations[0].";
  CHECK(warning("/animations/0/samplers/0/interpolation", "SMOOTH") ==
        begin + "samplers[0].interpolation: 'SMOOTH' is not an interpolation");
  CHECK(warning("/animations/0/samplers/0/input", 99) ==
        begin + "samplers[0].input: there is no accessors[99]");
  CHECK(warning("/animations/0/channels/0/sampler", 5) ==
        begin + "channels[0].sampler: is not an integer 0 to 0 (5)");
  CHECK(warning("/animations/0/channels/0/target/path", "weights") ==
        begin + "channels[0].target.path: the node's mesh has no morph targets");
  GltfRig rig = bending_tube();
  rig.clip("back");
  rig.channel(2, "rotation", {0, 1, 1}, rig.quadruples(joined({turn_z(0), turn_z(9), turn_z(0)})));
  CHECK(loaded(rig).warnings == Lines{begin + "samplers[0].input: key 2 is not later than the one before"});
  rig = bending_tube();
  rig.clip("short");
  rig.channel(2, "rotation", {0, 1}, rig.quadruples(turn_z(0)));
  CHECK(loaded(rig).warnings == Lines{begin + "samplers[0].output: has fewer values than there are keys"});
  rig = bending_tube();
  rig.clip("none");
  rig.channel(2, "rotation", {0, 1}, rig.quadruples({0, 0, 0, 1, 0, 0, 0, 0}));
  CHECK(loaded(rig).warnings == Lines{begin + "samplers[0].output: key 1 is no rotation"});
}

TEST_CASE("rigs: what is wrong with a skin is said with the place") {
  const std::string primitive = "meshes[0].primitives[0]";
  GltfRig rig = bending();
  rig.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  CHECK(complaint(rig) == primitive + ".attributes: has no JOINTS_0 and WEIGHTS_0 for the skin of its node");
  rig = bending();
  rig.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = rig.quadruples(Floats(4 * 36, 0.f));
  CHECK(loaded(rig).warnings ==
        Lines{primitive + ".attributes.WEIGHTS_0: vertices without a weight (36) follow their first joint"});
  rig = bending();
  rig.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = rig.quadruples(Floats(4 * 36, -1.f));
  CHECK(complaint(rig) ==
        primitive + ".attributes.WEIGHTS_0: vertex 0 has a weight that is negative or not finite");
  rig = bending();
  rig.json["skins"][0]["joints"] = json::array();
  CHECK(complaint(rig) == "skins[0].joints: is empty");
  rig = bending();
  rig.json["accessors"][0]["count"] = 4'000'000'000;
  CHECK(complaint(rig) == "accessors[0].count: is not an integer 0 to 4194304 (4000000000)");
  rig = bending();
  rig.json.erase("scene");
  rig.json.erase("scenes");
  rig.json["nodes"][2]["children"] = {0};
  CHECK(complaint(rig) == "nodes[0]: is a child of itself");
  rig = bending();
  rig.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  CHECK(complaint(rig) == "needs the extension 'KHR_draco_mesh_compression', which cannot be read");
}

TEST_CASE("rigs: a node of no size at rest has its triangles when a clip gives it one") {
  GltfRig rig = moved_square("scale", {0, 1}, {0, 0, 0, 2, 2, 2}, "LINEAR");
  rig.json["nodes"][0]["scale"] = {0, 0, 0};
  const Model model = loaded(rig);
  REQUIRE(model.triangle_count() == 1);
  CHECK(model.parts[0].mesh.positions.size() == 3);
  const Model grown = posed_at(model, 0, 1);
  double farthest = 0;
  for (const Vec3& p : grown.parts[0].mesh.positions) farthest = std::max(farthest, length(p));
  CHECK(farthest == Approx(std::sqrt(8)));
  GltfRig flat = moved_square("translation", {0, 1}, {0, 0, 0, 0, 1, 0}, "LINEAR");
  flat.json["nodes"][0]["scale"] = {1, 1, 0};
  CHECK(worst_of_pipeline(stored(loaded(flat)), 0, 1) < 32);
}

TEST_CASE("rigs: a triangle without area is kept if a morph target opens it") {
  // The first opens, the second has two corners that stay one, the third stays in its line.
  const Floats line = {0, 0, 0, 1, 0, 0, 2, 0, 0};
  const Floats base = joined({line, {0, 0, 0, 0, 0, 0, 2, 0, 0}, line});
  const Floats added = joined({{0, 0, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 1, 0}, Floats(9, 1.f)});
  const Model model = loaded(morphed(base, added));
  CHECK(model.triangle_count() == 1);
  CHECK(model.dropped_faces == 2);
  CHECK(triangles_of(stored(model)) == 1);
  const Model open = posed_at(model, 0, 1);
  CHECK(open.triangle_count() == 1);
  CHECK(least_cosine(open.parts[0].mesh) == Approx(1));
}

TEST_CASE("rigs: a triangle without area is kept if joints open it") {
  GltfRig rig = moved_square("translation", {0, 1}, {0, 0, 0, 0, 1, 0}, "LINEAR");
  rig.json["nodes"] = json::parse(R"([{}, {"mesh": 0, "skin": 0}, {}])");
  rig.json["scenes"][0]["nodes"] = {0, 1, 2};
  rig.json["skins"] = {{{"joints", {2, 0}}}};
  json& attributes = rig.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["POSITION"] = rig.vectors({0, 0, 0, 1, 0, 0, 1, 0, 0});
  attributes["JOINTS_0"] =
      rig.accessor("VEC4", 4, std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
  attributes["WEIGHTS_0"] = rig.quadruples({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const Model model = loaded(rig);
  REQUIRE(model.triangle_count() == 1);
  const FixedModel fixed = stored(model);
  CHECK(triangles_of(fixed) == 1);
  CHECK(worst_of_pipeline(fixed, 0, 1) < 32);
}

TEST_CASE("rigs: a model that is a point at rest has numbers there all the same") {
  const Model model = loaded(morphed(Floats(9), {0, 0, 0, 1, 0, 0, 0, 1, 0}));
  REQUIRE(model.triangle_count() == 1);
  const FixedModel at_rest = to_fixed(posed(model, rest_pose(*model.rig), "rig"));
  CHECK(at_rest.meshes[0].unit > 0);
  CHECK(at_rest.meshes[0].positions[0] == arcspan::ObjectPosition{0, 0, 0});
  CHECK(animation_error(stored(model)).position < 2);
}

TEST_CASE("rigs: morph targets turn the flat normals of files without normals") {
  // The target lifts the right edge of a triangle in the plane z = 0 by 45 degrees.
  GltfRig rig = morphed({0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 0, 0, 1, 0, 0, 1});
  const Vec3 tilted = normalised(Vec3{-1, 0, 1});
  const Model model = loaded(rig);
  for (const Vec3& n : normals_at(model, 0)) CHECK(length(n - Vec3{0, 0, 1}) < 1e-6);
  for (const Vec3& n : normals_at(model, 1)) CHECK(length(n - tilted) < 1e-6);
  const FixedModel fixed = stored(model);
  REQUIRE(fixed.animation->parts[0].morph->has_normals);
  for (const std::vector<FixedMorphRecord>& of_vertex : fixed.animation->parts[0].morph->records) {
    REQUIRE(of_vertex.size() == 1);
    CHECK(of_vertex[0].normal == std::array<std::int16_t, 3>{-11585, 0, 11585 - 16384});
  }
  rig.json["nodes"][0]["scale"] = {-1, 1, 1};
  for (const Vec3& n : normals_at(loaded(rig), 1)) CHECK(length(n - normalised(Vec3{1, 0, 1})) < 1e-6);
}

TEST_CASE("rigs: a face without area in the base has the flat normal of its morph target") {
  const Model model = loaded(morphed({0, 0, 0, 1, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, -1}));
  for (const double time : {0., .5, 1.}) {
    for (const Vec3& n : normals_at(model, time)) CHECK(n == Vec3{0, 1, 0});
  }
}

TEST_CASE("rigs: triangles turn round where a pose mirrors them, or no longer does") {
  const double of_tube = least_cosine(loaded(bending_tube()).parts[0].mesh);
  for (const float first : {1.f, -1.f}) {
    GltfRig rig = bending_tube();
    rig.json["nodes"][0]["scale"] = {first, 1, 1};
    rig.clip("flip");
    rig.channel(0, "scale", {0, 1}, rig.vectors({first, 1, 1, -first, 1, 1}), "STEP");
    const Model skinned = loaded(rig);
    rig.json["nodes"][3] = {{"mesh", 0}};  // without the skin
    for (const Model& model : {skinned, loaded(rig)}) {
      CHECK(least_cosine(model.parts[0].mesh) == Approx(of_tube));
      for (const double time : {0., 1.})
        CHECK(least_cosine(posed_at(model, 0, time).parts[0].mesh) == Approx(of_tube));
      const Model in_integers = posed_like(model, RuntimeModel(model, "rig").posed("flip", 1));
      CHECK(least_cosine(in_integers.parts[0].mesh) == Approx(of_tube).epsilon(1e-3));
    }
  }
}

TEST_CASE("rigs: the first node that a clip mirrors") {
  const auto mirrored = [](const Floats& scales) {
    const Model model = loaded(moved_square("scale", {0, 1, 2}, scales, "LINEAR"));
    return mirrored_node(*model.rig, model.rig->clips[0]);
  };
  CHECK(mirrored({1, 1, 1, -1, 1, 1, 1, 1, 1}) == 0u);
  CHECK_FALSE(mirrored({1, 1, 1, -1, -1, 1, 1, 1, 1}));
  CHECK_FALSE(mirrored({1, 1, 1, 0, 0, 0, 1, 1, 1}));
  GltfRig hidden = moved_square("scale", {0, 1}, {-1, 1, 1, 0, 0, 0}, "STEP");
  hidden.json["nodes"][0]["scale"] = {-1, 1, 1};
  const Model model = loaded(hidden);
  CHECK_FALSE(mirrored_node(*model.rig, model.rig->clips[0]));
}

TEST_CASE("rigs: the range of a morph weight holds cubic curves between their keys") {
  RigChannel channel;
  channel.path = ChannelPath::kMorphWeights;
  channel.interpolation = Interpolation::kCubic;
  channel.components = 1;
  channel.times = {0, 1};
  channel.values = {0, 0, 30, 0, 0, 0};
  Rig rig;
  rig.nodes.resize(1);
  rig.instances.resize(1);
  rig.instances[0].morph_weights = {0};
  rig.clips.resize(1);
  rig.clips[0].channels = {channel};
  const WeightRange range = weight_ranges(rig, 0)[0];
  for (int i = 0; i <= 1000; ++i) {
    const double weight = channel.at(i / 1000.)[0];
    CHECK((range.low <= weight && weight <= range.high));
  }
  CHECK(channel.at(1. / 3)[0] > 4.4);
}

TEST_CASE("rigs: instances of different skins are different parts, however equal they look") {
  const auto parts = [](int second_skin) {
    GltfRig rig = bending_tube();
    json& nodes = rig.json["nodes"];
    nodes.push_back(nodes[3]);
    nodes[4]["skin"] = second_skin;
    rig.json["scenes"][0]["nodes"] = {0, 4};
    rig.json["skins"].push_back({{"joints", {2, 1}}});
    return loaded(rig).parts.size();
  };
  CHECK(parts(0) == 1);
  CHECK(parts(1) == 2);
}

TEST_CASE("rigs: keys that linear interpolation gives within the tolerance are left out") {
  const RigChannel channel = turning(101, 60);
  const RigChannel few = thinned(channel, {0.5, 0, 0});
  CHECK(few.keys() < 15);
  CHECK(few.keys() > 4);
  CHECK(few.times.back() == 1);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i)
    worst = std::max(worst, degrees_apart(channel.at(i / 1000.), few.at(i / 1000.)));
  CHECK(worst <= 0.51);
  CHECK(worst > 0.2);
  CHECK(thinned(channel, {}).keys() == 101);
  CHECK(thinned(turning(50, 0), {}).keys() == 1);
  RigChannel negated = channel;  // q and -q are one rotation
  for (std::size_t i = 0; i < negated.values.size(); ++i) negated.values[i] *= i / 4 % 2 == 0 ? 1 : -1;
  CHECK(thinned(negated, {0.5, 0, 0}).keys() == few.keys());
}

TEST_CASE("rigs: keys are added where components do not interpolate a rotation well") {
  RigChannel channel = turning(2, 0);
  channel.values.clear();
  for (const float c : joined({turn_z(0), turn_z(170)})) channel.values.push_back(c);
  const RigChannel close = with_close_rotations(channel);
  CHECK(close.keys() > 2);
  CHECK(played_apart(close, channel) < 0.0021);
  CHECK(with_close_rotations(turning(100, 30)).keys() == 100);
  CHECK(with_close_rotations(turning(40'000, 40'000 * 20)).keys() ==
        40'000);  // a channel has no room for more
}

TEST_CASE("rigs: keys are left out by what components interpolate, not by the arc between two keys") {
  RigChannel channel = turning(2, 0);
  channel.values.clear();
  for (const float c : joined({turn_z(0), turn_z(170)})) channel.values.push_back(c);
  const RigChannel close = with_close_rotations(channel);
  const RigChannel few = thinned(close, {0.1, 0, 0});
  CHECK(few.keys() < close.keys());
  CHECK(played_apart(few, channel) < 0.1);
}

TEST_CASE("rigs: the tolerance of keys is a share of the model below scales, too") {
  const auto keys_below = [](float scale, const char* path) {
    const bool moves = std::string(path) == "translation";
    Floats times, values;
    for (int i = 0; i <= 30; ++i) {
      const float t = static_cast<float>(i) / 30;
      const float swing = std::sin(7 * t);
      times.push_back(t);
      for (int k = 0; k < 3; ++k) values.push_back((moves ? swing : 1 + swing / 4) / scale);
    }
    GltfRig rig = moved_square(path, times, values, "LINEAR");
    rig.json["nodes"][0]["scale"] = {1 / scale, 1 / scale, 1 / scale};
    rig.json["nodes"].push_back({{"scale", {scale, scale, scale}}, {"children", {0}}});
    rig.json["scenes"][0]["nodes"] = {1};
    const FixedModel fixed = stored(loaded(rig), {0.1, 0.01});
    CHECK(worst_of_pipeline(fixed, 0, 0.25) < 0.02 * 65534);
    return fixed.animation->clips.at(0).channels.at(0).times.size();
  };
  for (const char* path : {"translation", "scale"}) {
    const std::size_t keys = keys_below(1, path);
    CHECK(keys > 5);
    CHECK(keys < 25);
    CHECK(keys_below(100, path) == keys);
    CHECK(keys_below(.01f, path) == keys);
  }
}

TEST_CASE("rigs: weights in 1024ths add up, and are as near as they can be") {
  for (const std::vector<double>& weights : std::vector<std::vector<double>>{{1},
                                                                             {.5, .5},
                                                                             {1. / 3, 1. / 3, 1. / 3},
                                                                             {.9999, .0001},
                                                                             {.4, .3, .2, .1},
                                                                             {.7, .29, .0096, .0004}}) {
    const std::vector<std::uint16_t> fixed = fixed_weights(weights);
    CHECK(std::accumulate(fixed.begin(), fixed.end(), 0) == 1024);
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      CHECK(fixed[i] > 0);
      CHECK(std::abs(fixed[i] - weights[i] * 1024) < 1.01);
    }
  }
  CHECK(fixed_weights({.9999, .0001}).size() == 1);
}

TEST_CASE(
    "rigs: no triangle has two vertices in one slot of 64, and vertices come in the order of their use") {
  const FixedMesh torus = ordered(to_fixed(generate(*parse_generated_mesh("torus:48x24"))));
  const FixedMesh apart = with_separate_slots(torus);
  REQUIRE(apart.indices.size() == torus.indices.size());
  std::size_t before = 0;
  std::uint16_t newest = 0;
  for (std::size_t i = 0; i < apart.indices.size(); i += 3) {
    std::set<std::size_t> slots;
    std::set<std::size_t> old;
    for (std::size_t k = i; k < i + 3; ++k) {
      slots.insert(apart.indices[k] % kVertexSlots);
      old.insert(torus.indices[k] % kVertexSlots);
      CHECK(apart.indices[k] <= newest + 1);
      newest = std::max(newest, apart.indices[k]);
      const arcspan::ObjectPosition& a = apart.positions[apart.indices[k]];
      const arcspan::ObjectPosition& b = torus.positions[torus.indices[k]];
      CHECK((a.x == b.x && a.y == b.y && a.z == b.z));
    }
    CHECK(slots.size() == 3);
    before += old.size() < 3 ? 1u : 0u;
  }
  CHECK(before > 0);
  CHECK(apart.positions.size() <= torus.positions.size() + 3 * before);
}

TEST_CASE("rigs: the pipeline poses what is stored as doubles pose the file") {
  for (const float scale : {1.f, 0.01f, 40.f}) {
    CAPTURE(scale);
    GltfRig rig = bending_tube(17, scale);
    rig.clip("bend");
    rig.channel(2, "rotation", {0, .5f, 1}, rig.quadruples(joined({turn_z(0), turn_z(45), turn_z(-90)})));
    rig.channel(1, "translation", {0, 1}, rig.vectors({0, 0, 0, .5f / scale, 0, 0}));
    rig.channel(1, "scale", {0, 1}, rig.vectors({1, 1, 1, 1.5f, 1.5f, 1.5f}), "STEP");
    rig.clip("wave");
    rig.channel(2, "rotation", {0, 1},
                rig.quadruples(joined(
                    {Floats(4), turn_z(0), Floats{0, 0, 1, 0}, Floats{0, 0, .5f, 0}, turn_z(60), Floats(4)})),
                "CUBICSPLINE");
    const FixedModel fixed = stored(loaded(rig));
    const AnimationError error = animation_error(fixed);
    CHECK(error.position < 32);  // 1/2048 of the extent
    CHECK(error.normal_degrees < 0.3);
    for (const double time : {0., .25, .5, .8, 1.}) {
      CHECK(worst_of_pipeline(fixed, 0, time) < 32);
      CHECK(worst_of_pipeline(fixed, 1, time) < 32);
    }
  }
}

TEST_CASE("rigs: a mesh at a moving node follows one joint") {
  GltfRig rig = moved_square("rotation", {0, 1}, joined({turn_z(0), turn_z(80)}), "LINEAR");
  rig.json["nodes"] = json::parse(R"([{"mesh": 0, "translation": [3, 0, 0]}])");
  const FixedModel fixed = stored(loaded(rig));
  const Binary binary(fixed);
  CHECK(binary.animation.weights(0).are_of_one_joint());
  CHECK(binary.animation.find_node("") != arcspan::StoredAnimation::kNone);
  for (const double time : {0., .3, 1.}) CHECK(worst_of_pipeline(fixed, 0, time) < 32);
  rig.json["nodes"].push_back({{"name", "stand"}, {"children", {0}}});
  rig.json["scenes"][0]["nodes"] = {1};
  CHECK(Binary(stored(loaded(rig))).animation.find_node("stand") != arcspan::StoredAnimation::kNone);
}

TEST_CASE("rigs: what the format cannot hold is said with the node") {
  GltfRig rig = moved_square("rotation", {0, 1}, joined({turn_z(0), turn_z(80)}), "LINEAR");
  rig.json["nodes"] = json::parse(R"([{"mesh": 0}, {"name": "bent", "children": [0],
    "matrix": [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}])");
  rig.json["scenes"][0]["nodes"] = {1};
  CHECK(message_of<Failure>([&] { (void)stored(loaded(rig)); }) ==
        "rig: the node 0 'bent' is flat or sheared; --pose leaves the nodes out");
}

TEST_CASE("rigs: poses between keys are within 16 bits") {
  constexpr double kLimit = 32;  // 1/2048 of the extent
  // Out of the first key at 30 per second: the curve is farthest at a third, beyond both keys and the middle.
  GltfRig cubic = bending_tube();
  cubic.clip("jump");
  cubic.channel(1, "translation", {0, 1},
                cubic.vectors({0, 0, 0, 0, 0, 0, 30, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), "CUBICSPLINE");
  const FixedModel jumps = stored(loaded(cubic));
  for (int i = 0; i <= 32; ++i) {
    CAPTURE(i);
    CHECK(worst_of_pipeline(jumps, 0, i / 32.) < kLimit);
  }
}

/// A bar from 0 to 4 along x that one clip turns up and another down by `degrees`; at rest it is turned up.
GltfRig waving_bar(double degrees) {
  GltfRig rig = moved_square("rotation", {0}, turn_z(degrees), "LINEAR");
  rig.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
      rig.vectors({0, 0, 0, 4, 0, 0, 4, .1f, 0});
  rig.json["nodes"][0]["rotation"] = turn_z(degrees);
  rig.clip("down");
  rig.channel(0, "rotation", {0}, rig.quadruples(turn_z(-degrees)));
  return rig;
}

TEST_CASE("rigs: fades between clips are within 16 bits, which costs nothing where they are anyway") {
  for (const double degrees : {4., 20., 60.}) {
    CAPTURE(degrees);
    const FixedModel fixed = stored(loaded(waving_bar(degrees)));
    const Binary binary(fixed);
    const arcspan::ClipBlend half{{binary.animation.clip(0), 0}, {binary.animation.clip(1), 0}, 32768};
    double farthest = 0;
    for (const PosedVertex& vertex : posed_by_pipeline(binary, 0, half))
      farthest = std::max(farthest, vertex.position.x * fixed.meshes[0].unit + fixed.meshes[0].centre.x);
    CHECK(farthest == Approx(4).margin(.002));
  }
  const double widest = 4 * std::cos(4 * kDegree) + .1 * std::sin(4 * kDegree);
  CHECK(stored(loaded(waving_bar(4))).meshes[0].unit * 65534 == Approx(1.04 * widest).epsilon(2e-4));
}

TEST_CASE("rigs: a joint that takes vertices of others farther than the pipeline adds is refused") {
  const auto stretched = [](float distance, float weight) {
    GltfRig rig = bending_tube();
    Floats weights;
    for (int i = 0; i < 36; ++i) weights.insert(weights.end(), {1 - weight, weight, 0, 0});
    rig.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = rig.quadruples(weights);
    rig.clip("pull");
    rig.channel(2, "translation", {0, 1}, rig.vectors({0, 1, 0, distance, 1, 0}));
    return loaded(rig);
  };
  CHECK(worst_of_pipeline(stored(stretched(20, .3f)), 0, 1) < 64);
  CHECK(worst_of_pipeline(stored(stretched(20, .0004f)), 0, 1) < 300);  // such a weight is not stored
  CHECK(
      message_of<Failure>([&] { (void)stored(stretched(60, .1f)); }) ==
      "rig: the node 2 'upper' moves a vertex of several joints 4 extents of the model or more away from the "
      "middle of the model, or from where another joint moves it, in the clip 'pull'; --pose leaves the "
      "nodes "
      "out");
}

TEST_CASE("rigs: clips that move nothing of the model are named") {
  GltfRig rig = bending_tube();
  rig.json["nodes"].push_back({{"name", "lamp"}});
  rig.json["scenes"][0]["nodes"].push_back(4);
  rig.clip("bend");
  rig.channel(2, "rotation", {0, 1}, rig.quadruples(joined({turn_z(0), turn_z(70)})));
  rig.clip("swing");
  rig.channel(4, "translation", {0, 1}, rig.vectors({0, 0, 0, 1, 0, 0}));
  const FixedModel fixed = stored(loaded(rig));
  CHECK(fixed.animation->clips.size() == 1);
  CHECK(fixed.animation->still_clips == Lines{"swing"});
  GltfRig still = moved_square("translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "LINEAR");
  still.json["nodes"].push_back({{"name", "lamp"}});
  still.json["scenes"][0]["nodes"].push_back(1);
  still.json["animations"][0]["channels"][0]["target"]["node"] = 1;
  CHECK(loaded(still).warnings == Lines{"left out: animations that move nothing (1)"});
}

TEST_CASE("rigs: a chain of many joints is right between its keys") {
  for (const FixedModel& chain :
       {stored(loaded(curling_chain(20, 29))), stored(loaded(curling_chain(24, 20)))}) {
    for (int i = 0; i <= 32; ++i) CHECK(worst_of_pipeline(chain, 0, i / 32.) < 32);
  }
}

TEST_CASE("rigs: what a morph target adds before joints move it is within 16 bits") {
  // The joints turn by 90 degrees and pull down by what the target adds: the pose has the size of the mesh.
  GltfRig rig = stretching_tube();
  rig.clip("pull");
  rig.channel(0, "scale", {0, 1}, rig.vectors({1, 1, 1, .2f, .2f, .2f}));
  rig.channel(3, "weights", {0, 1}, rig.scalars({0, 4}));
  const FixedModel fixed = stored(loaded(rig));
  for (const double time : {0., .25, .5, 1.}) CHECK(worst_of_pipeline(fixed, 0, time) < 32);
}

TEST_CASE("rigs: the bound of a part holds it at all morph weights of its clips and at rest") {
  GltfRig rig = stretching_tube();
  rig.json["meshes"][0]["weights"] = {-3};
  rig.clip("pull");
  rig.channel(3, "weights", {0, 1}, rig.scalars({0, 2, 7, 0, 2, 0}), "CUBICSPLINE");  // up to 2 + 7 * 4/27
  const Binary binary(stored(loaded(rig)));
  CHECK(posed_by_pipeline(binary, 0, {}).size() == 36);
  for (const std::uint32_t time : {0u, 333'333u, 1'000'000u})
    CHECK(posed_by_pipeline(binary, 0, {{binary.animation.clip(0), time}, {}, 0}).size() == 36);
}

TEST_CASE("rigs: morph weights at rest that the format cannot hold are refused") {
  GltfRig rig = stretching_tube();
  rig.json["meshes"][0]["weights"] = {8.5};
  CHECK(message_of<Failure>([&] { (void)stored(loaded(rig)); }) ==
        "rig: a morph weight at rest (8.5) of the node 3 '' is out of range (weights are below 8)");
}

TEST_CASE("rigs: the reported error is that of the pipeline, at times of whole microseconds") {
  // Rotations of a chain that are off add up most at a fifth of the time between two keys.
  const FixedModel chain = stored(loaded(curling_chain(24, 20)));
  const double reported = animation_error(chain).position;
  CHECK(reported > .7 * worst_of_pipeline(chain, 0, .2) - 2);
  // As floats, 0.9 is less and 0.7 more than so many microseconds.
  GltfRig steps = bending_tube();
  steps.clip("steps");
  steps.channel(2, "translation", {0, .1f, .7f, .9f}, steps.vectors({0, 1, 0, 1, 1, 0, -1, 1, 0, 1, 2, 0}),
                "STEP");
  CHECK(animation_error(stored(loaded(steps))).position < 32);
}

TEST_CASE("rigs: the reported error saturates positions as the pipeline does") {
  FixedModel fixed = stored(loaded(stretching_tube()));
  auto animation = std::make_shared<FixedAnimation>(*fixed.animation);
  for (auto& of_vertex : animation->parts[0].morph->records) {
    for (FixedMorphRecord& record : of_vertex) record.position = {32767, 0, 0};
  }
  animation->parts[0].morph->weights = {32767};
  fixed.animation = animation;
  double farthest = 0;
  const StoredPose pose(fixed);
  for (std::size_t i = 0; i < fixed.meshes[0].positions.size(); ++i)
    farthest = std::max(farthest, pose.vertex(0, i).position.x);
  CHECK(farthest == 32767);
}

TEST_CASE("rigs: a jump between keys in one microsecond stays a jump") {
  const float next = std::nextafter(1.f, 2.f);
  const auto times = [](const GltfRig& rig) {
    return stored(loaded(rig)).animation->clips.at(0).channels.at(0).times;
  };
  using Times = std::vector<std::uint32_t>;
  const Floats values = {0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0};
  CHECK(times(moved_square("translation", {0, 1, next, 2}, values, "LINEAR")) ==
        Times{0, 1'000'000, 1'000'001, 2'000'000});
  // The key at the next microsecond keeps its place.
  CHECK(times(moved_square("translation", {0, 1, next, 1.000001f}, values, "LINEAR")) ==
        Times{0, 1'000'000, 1'000'001});
  const Floats three(values.begin(), values.begin() + 9);
  const FixedModel last = stored(loaded(moved_square("translation", {0, 1, next}, three, "LINEAR")));
  CHECK(last.animation->clips[0].channels[0].times.back() == 1'000'001);
  CHECK(last.animation->clips[0].duration == 1'000'001);
}

TEST_CASE("rigs: a stretched joint does not bend the normals of vertices that follow another") {
  GltfRig rig = bending_tube();
  // Joint 0 has no vertex; all follow joint 1.
  json& attributes = rig.json["meshes"][0]["primitives"][0]["attributes"];
  Floats weights;
  for (int i = 0; i < 36; ++i) weights.insert(weights.end(), {0, 1, 0, 0});
  attributes["WEIGHTS_0"] = rig.quadruples(weights);
  Floats pull;
  for (int i = 0; i < 36; ++i) pull.insert(pull.end(), {1, 1, 0});
  rig.json["meshes"][0]["primitives"][0]["targets"] = {{{"NORMAL", rig.vectors(pull)}}};
  rig.json["nodes"] = json::parse(R"([{"mesh": 0, "skin": 0, "children": [1, 2]}, {"scale": [3, 1, 1]},
    {"translation": [0, 1, 0]}])");
  rig.json["nodes"][2]["rotation"] = turn_z(30);
  rig.clip("turn");
  rig.channel(2, "rotation", {0, 1}, rig.quadruples(joined({turn_z(30), turn_z(70)})));
  rig.channel(0, "weights", {0, 1}, rig.scalars({0, 1}));
  const FixedModel fixed = stored(loaded(rig));
  const Binary binary(fixed);
  const RigPoser rest(*fixed.rig, rest_pose(*fixed.rig));
  const RigPoser poser(*fixed.rig, pose_at(*fixed.rig, fixed.rig->clips[0], 1));
  const std::vector<PosedVertex> posed =
      posed_by_pipeline(binary, 0, {{binary.animation.clip(0), 1'000'000}, {}, 0});
  for (std::size_t i = 0; i < posed.size(); ++i) {
    const arcspan::Direction& n = posed[i].direction;
    const Vec3 right = normalised(posed_normal(rest, poser, fixed.rig->vertices[fixed.meshes[0].sources[i]]));
    CHECK(length(Vec3{n.x.raw() / 32768., n.y.raw() / 32768., n.z.raw() / 32768.} - right) < 0.005);
  }
  CHECK(animation_error(fixed).normal_degrees < 0.3);
}

TEST_CASE("rigs: a skin whose joints are all stretched has the normals of the stretched shape at rest") {
  GltfRig rig = bending_tube();
  rig.json["nodes"][0]["scale"] = {3, 1, 1};
  Floats slanted;
  for (int i = 0; i < 36; ++i) slanted.insert(slanted.end(), {.6f, .8f, 0});
  rig.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = rig.vectors(slanted);
  const Model model = loaded(rig);
  const FixedModel fixed = stored(model);
  const Vec3 right = normalised(Vec3{.6 / 3, .8, 0});
  const Model at_rest = posed(model, rest_pose(*model.rig), "tube");
  for (const Vec3& normal : at_rest.parts[0].mesh.normals) CHECK(length(normal - right) < 1e-6);
  for (const PosedVertex& v : posed_by_pipeline(Binary(fixed), 0, {})) {
    const arcspan::Direction& n = v.direction;
    CHECK(length(Vec3{n.x.raw() / 32768., n.y.raw() / 32768., n.z.raw() / 32768.} - right) < 0.005);
  }
  CHECK(animation_error(fixed).normal_degrees < 0.3);
}

TEST_CASE("rigs: an animation that the library would refuse is not written") {
  GltfRig rig = bending_tube();
  rig.clip("bend");
  rig.channel(2, "rotation", {0, 1}, rig.quadruples(joined({turn_z(0), turn_z(70)})));
  FixedModel fixed = stored(loaded(rig));
  FixedAnimation animation = *fixed.animation;
  std::swap(animation.clips[0].channels[0].times[0], animation.clips[0].channels[0].times[1]);
  fixed.animation = std::make_shared<FixedAnimation>(animation);
  CHECK_THROWS_AS(model_binary_file(fixed), Failure);
}

TEST_CASE("rigs: a name that is too long is cut at a character, and stays the only one of its clip or node") {
  GltfRig rig = bending_tube();
  const std::string thirty = std::string(29, 'a') + "|";
  const std::string umlaut = std::string(30, 'u') + "\u00fc";
  for (const std::string& name : {thirty + "walk", thirty + "r", thirty + "run", umlaut}) {
    rig.clip(name.c_str());
    rig.channel(2, "translation", {0}, rig.vectors({0, 1, 0}));
  }
  rig.json["nodes"][1]["name"] = thirty + "left";
  rig.json["nodes"][2]["name"] = thirty + "lower";
  const FixedModel fixed = stored(loaded(rig));
  const Binary binary(fixed);
  Lines clips;
  for (std::size_t i = 0; i < binary.animation.clip_count(); ++i)
    clips.emplace_back(binary.animation.clip(i).name());
  CHECK(clips == Lines{thirty + "w", thirty + "r", std::string(29, 'a') + "|2", std::string(30, 'u')});
  Lines nodes;
  for (std::size_t i = 0; i < binary.animation.nodes().size(); ++i)
    nodes.emplace_back(binary.animation.node_name(i));
  CHECK(std::count(nodes.begin(), nodes.end(), thirty + "l") == 1);
  CHECK(std::count(nodes.begin(), nodes.end(), thirty + "2") == 1);
  CHECK(animation_error(fixed).position < 32);  // finds each clip
}

TEST_CASE("rigs: a clip's own name is not given to another") {
  const auto names = [](const Lines& of_file) {
    std::vector<RigClip> clips;
    for (const std::string& name : of_file) clips.push_back({name, {}});
    name_clips(clips);
    Lines given;
    for (const RigClip& clip : clips) given.push_back(clip.name);
    return given;
  };
  CHECK(names({"a", "a", "a2"}) == Lines{"a", "a3", "a2"});
  CHECK(names({"", "clip1", ""}) == Lines{"clip2", "clip1", "clip3"});
  CHECK(names({"", "", "b"}) == Lines{"clip1", "clip2", "b"});
}

TEST_CASE("rigs: a joint that grows from a small scale at rest, and vertices that follow a small joint") {
  for (const float small : {.01f, .001f}) {
    CAPTURE(small);
    GltfRig rig = bending_tube();
    rig.json["nodes"][1]["scale"] = {small, small, small};
    rig.clip("grow");
    rig.channel(1, "scale", {0, 1}, rig.vectors({small, small, small, 1, 1, 1}));
    const FixedModel fixed = stored(loaded(rig));
    for (const double time : {0., .5, 1.}) CHECK(worst_of_pipeline(fixed, 0, time) < 32);
  }
}

TEST_CASE("rigs: a first joint far away that moves no vertex costs no precision") {
  GltfRig rig = bending_tube();
  rig.json["nodes"].push_back({{"translation", {400, 0, 0}}});
  rig.json["nodes"][0]["children"].push_back(4);
  rig.json["skins"][0] = {{"joints", {4, 1, 2}}};
  std::vector<std::uint8_t> joints;
  for (int i = 0; i < 36; ++i) joints.insert(joints.end(), {1, 2, 0, 0});
  rig.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = rig.accessor("VEC4", 4, joints);
  rig.json["nodes"][2]["translation"] = {0, 0, 0};
  const FixedModel fixed = stored(loaded(rig));
  CHECK(fixed.meshes[0].unit * 65534 < 2.5);
}

TEST_CASE("rigs: a rotation below a stretched node that stands still is kept as a node") {
  GltfRig rig = moved_square("rotation", {0, 1}, joined({turn_z(0), turn_z(80)}), "LINEAR");
  rig.json["nodes"] =
      json::parse(R"([{"mesh": 0}, {"children": [0]}, {"children": [1], "scale": [1, 2, 1]}])");
  rig.json["nodes"][1]["rotation"] = turn_z(45);
  rig.json["scenes"][0]["nodes"] = {2};
  const FixedModel fixed = stored(loaded(rig));
  for (const double time : {0., .3, 1.}) CHECK(worst_of_pipeline(fixed, 0, time) < 32);
}

TEST_CASE("rigs: models of the loader's own collection") {
  const std::string folder = "/usr/share/assimp/models/glTF2/";
  if (!std::filesystem::exists(folder)) return;
  const Model skin = load_model_file(folder + "simple_skin/simple_skin.gltf");
  CHECK(skin.rig->skins[0].joints.size() == 2);
  CHECK(skin.rig->clips[0].name == "clip1");
  const AnimationError of_skin = animation_error(stored(skin));
  CHECK(of_skin.position < 32);
  const Model cube =
      load_model_file(folder + "glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf");
  CHECK(cube.rig->clips[0].name == "Square");
  CHECK(cube.rig->instances[0].morph_weights.size() == 2);
  const FixedModel fixed = stored(cube);
  CHECK(animation_error(fixed).position < 32);
  CHECK(Binary(fixed).animation.morph(0).target_count() == 2);
}
