// SPDX-License-Identifier: MIT
// Each status of a scene that cannot be drawn, and input without any sense.
#include <arcspan/checked.hpp>
#include <arcspan/pixel/sink_part.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>
#include <tests/support/misuse_recorder.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

// Objects refer to their mesh, material and parts: temporaries are refused, with a sphere too.
template <class... Arguments>
constexpr bool kMakesObject = std::is_constructible_v<Object, Arguments...>;
static_assert(kMakesObject<const MeshView&, const SceneMaterial&, const BoundingSphere&>);
static_assert(!kMakesObject<MeshView, const SceneMaterial&, const BoundingSphere&>);
static_assert(!kMakesObject<const MeshView&, const SceneMaterial, const BoundingSphere&>);
static_assert(!kMakesObject<MeshView, std::span<const Part>, const BoundingSphere&>);

const TestMesh kCube = make_smooth_cube(18000);
const MeshView kMesh = kCube.view();
SceneMemory<SceneMethods, 2, 8> memory_of_scene;
constexpr Camera kCamera = Camera::of({WorldPoint::of(0, 1, 5), {}}, kLens, kScreen);

Status status_of(const std::vector<Object>& objects, const LightList& lights = kLights,
                 const Camera& camera = kCamera) {
  Canvas canvas;
  const Status status =
      draw_scene({camera, lights, objects}, canvas.picture, canvas.depth, memory_of_scene).status;
  // Nothing is drawn, now or by a band that follows.
  if (!ok(status)) {
    CHECK(draw_prepared_scene(memory_of_scene, canvas.picture, canvas.depth).status == status);
    CHECK(canvas.pixels == Canvas().pixels);
  }
  return status;
}

}  // namespace

TEST_CASE("a scene that makes no sense is refused with its cause") {
  Object object(kMesh, kCopper);
  CHECK(status_of({object}) == Status::kOk);
  CHECK(status_of({object, object}) == Status::kOk);
  CHECK(status_of({object, object, object}) == Status::kTooManyObjects);
  CHECK(status_of({object}, kLights, Camera{}) == Status::kNotReady);

  Object tiny = object;
  tiny.scale = WorldLength::from_raw(63);
  CHECK(status_of({tiny}) == Status::kScaleOutOfRange);
  tiny.scale = WorldLength::from_raw(-65536);
  CHECK(status_of({tiny}) == Status::kScaleOutOfRange);

  const Part beyond[] = {{&kCopper, 10, 3}};
  CHECK(status_of({Object(kMesh, beyond)}) == Status::kIndexOutOfRange);
  const Part wrapping[] = {{&kCopper, 2, SIZE_MAX}};
  CHECK(status_of({Object(kMesh, wrapping)}) == Status::kIndexOutOfRange);
  const Part bare[] = {{nullptr, 0, 3}};
  CHECK(status_of({Object(kMesh, bare)}) == Status::kInvalidArgument);

  static constexpr auto kFlat = PreparedMaterial<Flat<SceneLighting>>::of(Material{}, kLights);
  CHECK(status_of({Object(kMesh, kFlat)}) == Status::kMethodNotListed);

  Random random(1831);
  const TestMesh large = make_sphere(4, 6, 30000, 0, random);
  const MeshView large_view = large.view();
  CHECK(status_of({Object(large_view, kCopper)}) == Status::kCacheTooSmall);
}

TEST_CASE("nothing is drawn before a frame is prepared") {
  static SceneMemory<SceneMethods, 1> unused;
  Canvas canvas;
  CHECK(draw_prepared_scene(unused, canvas.picture, canvas.depth).status == Status::kNotReady);
}

TEST_CASE("lights that a method cannot show are refused") {
  const SceneLight sun = SceneLight::directional(arcspan::normalised(1, 1, 1), Coefficient::of(0.5));
  const SceneLight three[] = {sun, sun, sun};
  const Object lit(kMesh, kCopper);
  const Object unlit(kMesh, kRed);
  CHECK(status_of({lit}, {three}) == Status::kTooManyLights);
  CHECK(status_of({unlit}, {three}) == Status::kOk);
  const SceneLight five[] = {sun, sun, sun, sun, sun};
  CHECK(status_of({unlit}, {five}) == Status::kTooManyLights);
  CHECK(status_of({lit}, {{three, 1}}) == Status::kOk);
  CHECK(status_of({lit}, {}) == Status::kOk);

  const SceneLight red[] = {SceneLight::directional(arcspan::normalised(1, 1, 1), Coefficient::of(0.5),
                                                    {Coefficient::of(1.0), Coefficient{}, Coefficient{}})};
  CHECK(status_of({lit}, {red}) == Status::kUnsupported);
  const SceneLight bright[] = {
      SceneLight::directional(arcspan::normalised(1, 1, 1), Coefficient::from_raw(32769))};
  CHECK(status_of({lit}, {bright}) == Status::kInvalidArgument);

  PreparedMaterial<SceneMethod> prepared;
  CHECK(PreparedMaterial<SceneMethod>::make(Material{}, {three}, {}, prepared) == Status::kTooManyLights);
  CHECK(PreparedMaterial<SceneMethod>::make(Material{}, {red}, {}, prepared) == Status::kUnsupported);
  LightList dazzling = kLights;
  dazzling.ambient.g = Coefficient::from_raw(-1);
  CHECK(PreparedMaterial<SceneMethod>::make(Material{}, dazzling, {}, prepared) == Status::kInvalidArgument);
}

TEST_CASE("a point light whose half distance is not above 0 is refused") {
  const Object object(kMesh, kCopper);
  for (const std::int32_t raw : {0, -1, INT32_MIN}) {
    const SceneLight lamps[] = {SceneLight::point(WorldPoint::of(1, 1, 1), WorldLength::from_raw(raw))};
    CHECK(status_of({object}, {lamps}) == Status::kInvalidArgument);
    PreparedMaterial<SceneMethod> prepared;
    CHECK(PreparedMaterial<SceneMethod>::make(Material{}, {lamps}, {}, prepared) == Status::kInvalidArgument);
  }
  const SceneLight lamps[] = {SceneLight::point(WorldPoint::of(1, 1, 1), WorldLength::from_raw(1))};
  CHECK(status_of({object}, {lamps}) == Status::kOk);
}

TEST_CASE(
    "a scene with a background clears colours and depths, in bands and at once, and nothing if refused") {
  const Object object(kMesh, kCopper);
  const Scene scene{kCamera, kLights, {&object, 1}};
  Canvas right;
  right.picture.clear({0, 0, 40});
  REQUIRE(draw_scene(scene, right.picture, right.depth, memory_of_scene).status == Status::kOk);
  const auto scribble = [](Canvas& canvas) {
    std::fill(canvas.pixels.begin(), canvas.pixels.end(), Picture::Word{99});
    std::fill(canvas.depths.begin(), canvas.depths.end(), std::uint16_t{0});
  };
  Canvas whole;
  scribble(whole);
  CHECK(draw_scene(scene, whole.picture, whole.depth, memory_of_scene, {0, 0, 40}).status == Status::kOk);
  CHECK(whole.pixels == right.pixels);
  Canvas band(24);
  REQUIRE(ok(prepare_scene(scene, memory_of_scene)));
  for (std::int32_t top = 0; top < Canvas::kHeight; top += 24) {
    band.picture.move_to(top);
    band.depth.move_to(top);
    scribble(band);
    CHECK(draw_prepared_scene(memory_of_scene, band.picture, band.depth, {0, 0, 40}).status == Status::kOk);
    CHECK(
        std::equal(band.pixels.begin(), band.pixels.end(),
                   right.pixels.begin() + static_cast<std::ptrdiff_t>(Picture::words(Canvas::kWidth, top))));
  }
  // A sink without clear() of its own.
  SinkPart part(whole.picture, whole.picture.bounds());
  scribble(whole);
  CHECK(draw_scene(scene, part, whole.depth, memory_of_scene, Rgb8{0, 0, 40}).status == Status::kOk);
  CHECK(whole.pixels == right.pixels);
  scribble(whole);
  const std::vector<Picture::Word> before = whole.pixels;
  const Camera not_made;
  CHECK(draw_scene({not_made, kLights, {&object, 1}}, whole.picture, whole.depth, memory_of_scene, {0, 0, 40})
            .status == Status::kNotReady);
  CHECK(draw_scene(scene, whole.picture, band.depth, memory_of_scene, {0, 0, 40}).status ==
        Status::kDepthMismatch);
  CHECK(whole.pixels == before);
}

namespace {

using Causes = std::vector<std::string>;

/// The cause that `call` gives to on_misuse().
template <class Call>
Causes causes_of(Call&& call) {
  MisuseRecorder recorder;
  call();
  return recorder.take();
}

}  // namespace

TEST_CASE("builds with checks report calls that cannot mean what they say") {
  if (!kIsChecked) return;
  const Object object(kMesh, kCopper);
  const Scene scene{kCamera, kLights, {&object, 1}};
  const auto drawn = [&](const DepthBuffer& depth) {
    return causes_of([&] {
      Canvas canvas;
      (void)draw_scene(scene, canvas.picture, depth, memory_of_scene);
    });
  };
  std::vector<std::uint16_t> memory(DepthBuffer::words(Canvas::kWidth, Canvas::kHeight));
  const auto buffer = [&](std::int32_t rows) { return DepthBuffer(memory, Canvas::kWidth, rows); };
  const Causes never{"draw: the depth buffer was never cleared"};
  const DepthBuffer untouched = buffer(Canvas::kHeight);
  CHECK(drawn(untouched) == never);
  CHECK(drawn(untouched).empty());                                  // reported once
  std::fill(memory.begin(), memory.end(), DepthBuffer::kFarthest);  // cleared without clear()
  CHECK(drawn(buffer(Canvas::kHeight)).empty());
  CHECK(drawn(buffer(Canvas::kHeight)).empty());  // as another object left it
  const auto drawn_band = [&](bool clears) {
    return causes_of([&] {
      Canvas canvas(36);
      DepthBuffer depth = buffer(36);
      for (std::int32_t top = 0; top < Canvas::kHeight; top += 36) {
        canvas.picture.move_to(top);
        depth.move_to(top);
        if (clears || top == 0) depth.clear();
        (void)draw_scene(scene, canvas.picture, depth, memory_of_scene);
      }
    });
  };
  CHECK(drawn_band(true).empty());
  CHECK(drawn_band(false) == Causes{"draw: the depth buffer was moved to another band, but not cleared"});

  const PreparedMaterial<SceneMethod> unmade;
  const MeshView empty;
  const auto shown = [&](const MeshView& mesh, const SceneMaterial& material, const Rotation& rotation) {
    return causes_of([&] {
      Canvas canvas;
      Object one(mesh, material, BoundingSphere{{}, 30000});
      one.rotation = rotation;
      (void)draw_scene({kCamera, kLights, {&one, 1}}, canvas.picture, canvas.depth, memory_of_scene);
    });
  };
  CHECK(shown(kMesh, kCopper, Rotation::identity()).empty());
  CHECK(shown(kMesh, unmade, Rotation::identity()) == Causes{"draw: the light of an object was never made"});
  CHECK(shown(empty, kCopper, Rotation::identity()) == Causes{"draw: the mesh was never made"});
  CHECK(causes_of([&] {
          MeshView later;
          const Object early(later, kCopper);  // as members of a class, the mesh of which load() makes
          later = kMesh;
          Canvas canvas;
          (void)draw_scene({kCamera, kLights, {&early, 1}}, canvas.picture, canvas.depth, memory_of_scene);
        }) == Causes{"scene: the bounding sphere of an object is a point: it was made before its mesh"});
  CHECK(shown(kMesh, kCopper, Rotation{}) == Causes{"scene: the rotation of an object is not orthonormal"});
  CHECK(causes_of([&] { Camera(kCamera).set_pose({}, Rotation{}); }) ==
        Causes{"Camera::set_pose: the rotation is not orthonormal"});
  CHECK(causes_of([&] { (void)SceneLight::directional({}); }) ==
        Causes{"SceneLight::directional: the direction is not a unit vector"});
  using Lit = Illumination<1, Highlight::kBlinn>;
  Lit lit;
  const Direction ahead = arcspan::normalised(0, 0, 1);
  CHECK(causes_of([&] { (void)Lit::make(Material{}, {DirectionalLight{}}, ahead, lit); }) ==
        Causes{"Illumination::make: the direction to a light is not a unit vector"});
  CHECK(causes_of([&] { (void)Lit::make(Material{}, {DirectionalLight{ahead}}, {}, lit); }) ==
        Causes{"Illumination::make: to_eye is not a unit vector"});
  ClipTransform transform;
  CHECK(causes_of([&] {
          (void)ClipTransform::make({}, {PixelLength::of(9), ObjectLength::of(1), ObjectLength::of(2)},
                                    {9, 9}, transform);
        }) == Causes{"ClipTransform::make: the rotation is not orthonormal"});
}

// The macro is nothing at all in other builds, so that they have the objects that they would have without it.
#define ARCSPAN_TEXT(...) #__VA_ARGS__
#define ARCSPAN_TEXT_OF(...) ARCSPAN_TEXT(__VA_ARGS__)
TEST_CASE("builds without checks contain none of them") {
  if (kIsChecked) return;
  CHECK(std::string(ARCSPAN_TEXT_OF(ARCSPAN_CHECK(false, "cause"))) == "static_cast<void>(0)");
  CHECK(std::is_empty_v<arcspan::CheckedState>);
  CHECK(sizeof(DepthBuffer) == sizeof(void*) + sizeof(Rect) + sizeof(void*));
}

TEST_CASE("targets that do not fit are refused") {
  const Object object(kMesh, kCopper);
  Canvas canvas;
  Canvas band(16);
  const Scene scene{kCamera, kLights, {&object, 1}};
  CHECK(draw_scene(scene, canvas.picture, band.depth, memory_of_scene).status == Status::kDepthMismatch);
  band.picture.move_to(16);
  CHECK(draw_scene(scene, band.picture, band.depth, memory_of_scene).status == Status::kDepthMismatch);
  band.depth.move_to(16);
  CHECK(draw_scene(scene, band.picture, band.depth, memory_of_scene).status == Status::kOk);
  Picture small({}, Canvas::kWidth, Canvas::kHeight);
  CHECK(draw_scene(scene, small, canvas.depth, memory_of_scene).status == Status::kBufferTooSmall);
  // A band below the picture has nothing to draw.
  band.move_to(1000);
  CHECK(draw_scene(scene, band.picture, band.depth, memory_of_scene).status == Status::kOk);
}

TEST_CASE("two-sided materials draw the backs of faces") {
  static constexpr auto kTwoSided =
      PreparedMaterial<SceneMethod>::of(matter(Coefficient::of(0.5), {}, {}), kLights, {.two_sided = true});
  const TestMesh hollow = kCube.inside_out();
  const MeshView view = hollow.view();
  const auto triangles = [&](const SceneMaterial& material) {
    const Object object(view, material);
    Canvas canvas;
    return draw_scene({kCamera, kLights, {&object, 1}}, canvas.picture, canvas.depth, memory_of_scene)
        .triangles;
  };
  CHECK(triangles(kTwoSided) == 12);
  CHECK(triangles(kCopper) < 12);
}

TEST_CASE("no number leads to undefined behaviour") {
  Random random(1832);
  const auto word = [&] {
    const auto bits = static_cast<std::int32_t>(random.bits());
    switch (random.integer(0, 4)) {
      case 0:
        return bits;
      case 1:
        return INT32_MIN + (bits & 3);
      case 2:
        return INT32_MAX - (bits & 3);
      case 3:
        return bits >> (random.bits() & 31);
      default:
        return bits & 0xFF;
    }
  };
  const auto length = [&] { return WorldLength::from_raw(word()); };
  const auto point = [&] { return WorldPoint{length(), length(), length()}; };
  const auto rotation = [&] {
    if (random.chance(0.5)) return random_rotation(random);
    const auto entry = [&] { return RotationEntry::from_raw(word()); };
    if (random.chance(0.5)) return rotation_of(Quaternion{entry(), entry(), entry(), entry()});
    Rotation made{};  // not orthonormal, with entries of -1...1 or of all that the format has
    const int dropped = random.chance(0.5) ? 1 : 0;
    for (auto& row : made.m) {
      for (RotationEntry& e : row) e = RotationEntry::from_raw(word() >> dropped);
    }
    return made;
  };
  int drawn = 0;
  int accepted = 0;
  MisuseRecorder ignored;
  for (int i = 0; i < share_of(20000); ++i) {
    const auto lens = [&] {
      switch (random.integer(0, 2)) {
        case 0:
          return Lens::field_of_view({static_cast<std::uint16_t>(word())}, length(), length());
        case 1:
          return Lens::focal_length(PixelLength::from_raw(word()), length(), length());
        default:
          return Lens::orthographic(length(), length(), length());
      }
    };
    Camera camera = kCamera;
    const Viewport viewport{random.chance(0.9) ? random.integer(1, 2048) : word(),
                            random.chance(0.9) ? random.integer(1, 2048) : word()};
    LookAt view{point(), point()};
    view.up = {DirectionComponent::from_raw(word() >> 15), DirectionComponent::from_raw(word() >> 15),
               DirectionComponent::from_raw(word() >> 15)};
    if (random.chance(0.9) && ok(Camera::make(view, lens(), viewport, camera))) ++accepted;
    if (random.chance(0.2)) camera.set_pose(point(), rotation());
    const SceneLight lights[] = {
        SceneLight::directional({DirectionComponent::from_raw(word()), DirectionComponent::from_raw(word()),
                                 DirectionComponent::from_raw(word())}),
        SceneLight::point(point(), length(), Coefficient::from_raw(random.integer(0, 32768)))};
    Object object(kMesh, random.chance(0.5) ? static_cast<const SceneMaterial&>(kCopper) : kRed,
                  random.chance(0.7)
                      ? bounding_sphere(kMesh)
                      : BoundingSphere{{32767, -32768, 32767}, static_cast<std::uint16_t>(word())});
    object.position = point();
    object.rotation = rotation();
    object.scale = length();
    Canvas canvas(20);
    canvas.picture.move_to(random.integer(0, 60));
    canvas.depth.move_to(canvas.picture.bounds().top);
    const SceneResult result =
        draw_scene({camera, {lights}, {&object, 1}}, canvas.picture, canvas.depth, memory_of_scene);
    if (result.objects != 0) ++drawn;
  }
  CHECK(accepted > share_of(20000) / 100);
  CHECK(drawn > share_of(20000) / 200);
}
