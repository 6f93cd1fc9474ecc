// SPDX-License-Identifier: MIT
// The C interface draws the pixels of the same program in C++, and refuses what it cannot do.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/pixel/bgr888.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/version.hpp>

#include <arcspan.h>
#include <arcspan_c/model.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

extern "C" {
extern const arcspan_model ball;
}

namespace {

using namespace arcspan;

constexpr std::uint16_t kWidth = 96;
constexpr std::uint16_t kHeight = 64;
constexpr arcspan_rgb kGround = {10, 20, 60};
constexpr arcspan_shares kWhiteLight = {32768, 32768, 32768};
constexpr arcspan_lens kLens = {kWidth, kHeight,           ARCSPAN_DEGREES(44),
                                0,      ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(9)};
constexpr arcspan_point kEye = {0, ARCSPAN_LENGTH(0.4), ARCSPAN_LENGTH(4)};

/// Two balls, and a view of them, in memory that has no byte more than is asked for.
struct Balls {
  std::vector<unsigned char> scene_memory;
  std::vector<unsigned char> view_memory;
  arcspan_scene* scene = nullptr;
  arcspan_view* view = nullptr;
  arcspan_object left = 0;
  arcspan_object right = 0;

  Balls() {
    const arcspan_scene_limits limits{2, 0};
    scene_memory.resize(arcspan_scene_bytes(&limits));
    REQUIRE(arcspan_scene_make(scene_memory.data(), scene_memory.size(), &limits, &scene) == ARCSPAN_OK);
    REQUIRE(arcspan_add_model(scene, &ball, &left) == ARCSPAN_OK);
    REQUIRE(arcspan_add_model(scene, &ball, &right) == ARCSPAN_OK);
    const arcspan_light light{{-3, 4, 5}, 0, 32768, kWhiteLight};
    REQUIRE(arcspan_set_lights(scene, &light, 1, kWhiteLight) == ARCSPAN_OK);
    REQUIRE(arcspan_set_position(scene, left, {ARCSPAN_LENGTH(-0.7), 0, 0}) == ARCSPAN_OK);
    REQUIRE(arcspan_set_position(scene, right, {ARCSPAN_LENGTH(0.7), ARCSPAN_LENGTH(0.2), 0}) == ARCSPAN_OK);
    REQUIRE(arcspan_set_scale(scene, right, ARCSPAN_LENGTH(0.75)) == ARCSPAN_OK);
    REQUIRE(arcspan_set_angles(scene, left, 3000, 4000, 5000) == ARCSPAN_OK);
    make_view(arcspan_limits_of(scene, 0));
  }
  void make_view(arcspan_view_limits limits) {
    view_memory.assign(arcspan_view_bytes(&limits), 0xA5);
    REQUIRE(arcspan_view_make(view_memory.data(), view_memory.size(), &limits, scene, &view) == ARCSPAN_OK);
    REQUIRE(arcspan_set_camera(view, &kLens, kEye, {0, 0, 0}, {0, 0, 0}) == ARCSPAN_OK);
  }
};

/// The same in C++.
template <class F>
std::vector<typename F::Word> drawn_by_cpp() {
  const c::ModelPart& part = ball.parts[0];
  MeshView mesh;
  REQUIRE(ok(part.make_view(mesh)));
  Object objects[] = {{mesh, *part.material, part.sphere}, {mesh, *part.material, part.sphere}};
  objects[0].position = WorldPoint::of(-0.7, 0, 0);
  objects[0].rotation = rotation_of(EulerAngles{{3000}, {4000}, {5000}});
  objects[1].position = WorldPoint::of(0.7, 0.2, 0);
  objects[1].scale = WorldLength::of(0.75);
  const SceneLight light = SceneLight::directional(normalised(-3, 4, 5));
  Camera camera;
  REQUIRE(
      ok(Camera::make({WorldPoint::of(0, 0.4, 4), {}},
                      Lens::field_of_view(Turn{ARCSPAN_DEGREES(44)}, WorldLength::of(1), WorldLength::of(9)),
                      {kWidth, kHeight}, camera)));
  using Frame = hal::Framebuffer<F>;
  std::vector<typename F::Word> memory(Frame::words(kWidth, kHeight));
  std::vector<std::uint16_t> depths(DepthBuffer::words(kWidth, kHeight));
  Frame frame(memory, kWidth, kHeight);
  const DepthBuffer depth(depths, kWidth, kHeight);
  static SceneMemory<c::CompiledMethods, 2, 512> scene_memory;
  REQUIRE(ok(draw_scene({camera, {{&light, 1}}, objects}, frame, depth, scene_memory,
                        Rgb8{kGround.r, kGround.g, kGround.b})
                 .status));
  return memory;
}

arcspan_target whole_target(void* pixels, std::size_t bytes, std::int32_t stride, arcspan_format format,
                            std::vector<std::uint16_t>& depths) {
  const arcspan_rect all{0, 0, kWidth, kHeight};
  depths.assign(arcspan_depth_words(all), 1);
  return {pixels, bytes, stride, format, all, depths.data(), depths.size(), &kGround};
}

template <class F>
void check_format(arcspan_format format, int keeps_vertices, std::uint32_t triangles) {
  const auto expected = drawn_by_cpp<F>();
  const std::size_t row = expected.size() / kHeight * sizeof(typename F::Word);
  Balls balls;
  arcspan_view_limits limits = arcspan_limits_of(balls.scene, keeps_vertices);
  limits.triangles = triangles;
  balls.make_view(limits);
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  std::vector<std::uint16_t> depths;
  // Whole, with rows that are padded.
  const std::size_t stride = row + 8;
  std::vector<unsigned char> padded(stride * kHeight, 0x5A);
  arcspan_target target =
      whole_target(padded.data(), padded.size(), static_cast<std::int32_t>(stride), format, depths);
  REQUIRE(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
  const auto* bytes = reinterpret_cast<const unsigned char*>(expected.data());
  for (std::size_t y = 0; y < kHeight; ++y) {
    REQUIRE(std::memcmp(padded.data() + y * stride, bytes + y * row, row) == 0);
    REQUIRE(padded[y * stride + row] == 0x5A);
  }
  // In rectangles of 32x20 pixels.
  const std::size_t pixel = row / kWidth;
  for (std::int32_t top = 0; top < kHeight; top += 20) {
    for (std::int32_t left = 0; left < kWidth; left += 32) {
      const std::int32_t bottom = top + 20 < kHeight ? top + 20 : kHeight;
      std::vector<unsigned char> part(32 * pixel * 20);
      target.pixels = part.data();
      target.bytes = part.size();
      target.stride = static_cast<std::int32_t>(32 * pixel);
      target.held = {left, top, left + 32, bottom};
      REQUIRE(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
      for (std::int32_t y = top; y < bottom; ++y) {
        REQUIRE(
            std::memcmp(part.data() + static_cast<std::size_t>(y - top) * 32 * pixel,
                        bytes + static_cast<std::size_t>(y) * row + static_cast<std::size_t>(left) * pixel,
                        32 * pixel) == 0);
      }
    }
  }
}

TEST_CASE("C draws the pixels of C++, whole, padded and in rectangles") {
  check_format<Rgb565>(ARCSPAN_RGB565, 0, 0);
  check_format<Bgr888>(ARCSPAN_BGR888, 0, 0);
}

TEST_CASE("C keeps the rows of as many triangles as the limits say") {
  Balls balls;
  const std::uint32_t all = arcspan_limits_of(balls.scene, 1).triangles;
  MeshView mesh;
  REQUIRE(ok(ball.parts[0].make_view(mesh)));
  CHECK(all == 2 * mesh.triangle_count());
  CHECK(arcspan_limits_of(balls.scene, 0).triangles == 0);
  check_format<Rgb565>(ARCSPAN_RGB565, 1, all);
  check_format<Rgb565>(ARCSPAN_RGB565, 0, all - 1);  // those of one ball
  arcspan_view_limits limits = arcspan_limits_of(balls.scene, 0);
  const std::size_t without = arcspan_view_bytes(&limits);
  limits.triangles = 64;
  CHECK(arcspan_view_bytes(&limits) == without + 2 * 68);
  limits.triangles = UINT32_MAX;
  CHECK((sizeof(std::size_t) > 4 || arcspan_view_bytes(&limits) == SIZE_MAX));
}

TEST_CASE("without a background, C draws over the pixels that are there") {
  Balls balls;
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  std::vector<std::uint16_t> pixels(kWidth * kHeight, 0x1234);
  std::vector<std::uint16_t> depths;
  arcspan_target target = whole_target(pixels.data(), 2 * pixels.size(), 2 * kWidth, ARCSPAN_RGB565, depths);
  target.background = nullptr;
  REQUIRE(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
  CHECK(pixels.front() == 0x1234);
  CHECK(pixels[kWidth * (kHeight / 2) + kWidth / 4] != 0x1234);
}

TEST_CASE("two views show one scene") {
  Balls balls;
  arcspan_view_limits limits = arcspan_limits_of(balls.scene, 0);
  std::vector<unsigned char> memory(arcspan_view_bytes(&limits));
  arcspan_view* second = nullptr;
  REQUIRE(arcspan_view_make(memory.data(), memory.size(), &limits, balls.scene, &second) == ARCSPAN_OK);
  REQUIRE(arcspan_set_camera(second, &kLens, {ARCSPAN_LENGTH(4), 0, 0}, {0, 0, 0}, {0, 0, 0}) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(second) == ARCSPAN_OK);
  std::vector<std::uint16_t> first_pixels(kWidth * kHeight), second_pixels(kWidth * kHeight), depths;
  arcspan_target target =
      whole_target(second_pixels.data(), 2 * second_pixels.size(), 2 * kWidth, ARCSPAN_RGB565, depths);
  REQUIRE(arcspan_draw(second, &target) == ARCSPAN_OK);
  target.pixels = first_pixels.data();
  REQUIRE(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
  CHECK(first_pixels == drawn_by_cpp<Rgb565>());
  CHECK(first_pixels != second_pixels);
}

TEST_CASE("quaternions of C turn as those of C++, and products do not drift") {
  arcspan_quaternion q{1 << 30, 0, 0, 0};
  const arcspan_quaternion step{1 << 30, 1 << 20, 1 << 22, 0};
  for (int i = 0; i < 1000; ++i) q = arcspan_multiply(step, q);
  const double length = double(q.w) * q.w + double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z;
  CHECK(length == Approx(double(1 << 30) * (1 << 30)).epsilon(1e-7));
  Balls balls;
  CHECK(arcspan_set_quaternion(balls.scene, balls.left, q) == ARCSPAN_OK);
  CHECK(arcspan_set_quaternion(balls.scene, 2, q) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_multiply({0, 1 << 30, 0, 0}, {0, 0, 1 << 30, 0}).z == 1 << 30);  // ij = k
}

TEST_CASE("a drag turns the nearest point of an object with it") {
  Balls balls;
  const arcspan_quaternion none{1 << 30, 0, 0, 0};
  // From the right: the picture's right is -z, its up is y.
  REQUIRE(arcspan_set_camera(balls.view, &kLens, {ARCSPAN_LENGTH(4), 0, 0}, {0, 0, 0}, {0, 0, 0}) ==
          ARCSPAN_OK);
  const arcspan_quaternion right = arcspan_dragged(balls.view, none, 16, 0);  // about +y
  CHECK(right.y > 0);
  CHECK((right.x == 0 && right.z == 0));
  const arcspan_quaternion down = arcspan_dragged(balls.view, none, 0, 16);  // about the right, -z
  CHECK(down.z < 0);
  CHECK((std::abs(down.x) < 64 && down.y == 0));
  // 2 atan(16 / 64): a point of a ball that fills the 64 pixels follows the finger at first.
  CHECK(right.y / double(1 << 30) == Approx(std::sin(std::atan(16.0 / 64))).margin(1e-6));
  const arcspan_quaternion back = arcspan_dragged(balls.view, right, -16, 0);
  CHECK(std::abs(back.y) <= 256);  // 18 fraction bits of the sides of the picture
  CHECK(arcspan_dragged(balls.view, none, INT32_MIN, INT32_MAX).w != 0);
  CHECK(arcspan_dragged(balls.view, none, INT32_MAX, 0).y == arcspan_dragged(balls.view, none, 4096, 0).y);
  arcspan_lens upright = kLens;
  upright.width = 32;
  REQUIRE(arcspan_set_camera(balls.view, &upright, {0, 0, ARCSPAN_LENGTH(4)}, {0, 0, 0}, {1, 0, 0}) ==
          ARCSPAN_OK);
  const arcspan_quaternion narrow = arcspan_dragged(balls.view, none, 16, 0);  // about its up, x
  CHECK(narrow.x / double(1 << 30) == Approx(std::sin(std::atan(16.0 / 32))).margin(1e-6));
  const arcspan_view_limits limits = arcspan_limits_of(balls.scene, 0);
  REQUIRE(arcspan_view_make(balls.view_memory.data(), balls.view_memory.size(), &limits, balls.scene,
                            &balls.view) == ARCSPAN_OK);
  CHECK(arcspan_dragged(balls.view, narrow, 16, 0).x == narrow.x);  // no camera
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_NOT_READY);
  // Its up is -z, its right -y.
  REQUIRE(arcspan_set_camera(balls.view, &kLens, {ARCSPAN_LENGTH(4), 0, 0}, {0, 0, 0}, {0, 0, -7}) ==
          ARCSPAN_OK);
  CHECK(arcspan_dragged(balls.view, none, 16, 0).z < 0);
}

TEST_CASE("the rectangle of a frame is that of the pixels that change") {
  Balls balls;
  CHECK(arcspan_drawn_rect(balls.view).right == 0);
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  const arcspan_rect drawn = arcspan_drawn_rect(balls.view);
  std::vector<std::uint16_t> pixels(kWidth * kHeight, 0x1234), depths;
  arcspan_target target = whole_target(pixels.data(), 2 * pixels.size(), 2 * kWidth, ARCSPAN_RGB565, depths);
  target.background = nullptr;
  REQUIRE(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
  arcspan_rect changed{kWidth, kHeight, 0, 0};
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      if (pixels[static_cast<std::size_t>(y * kWidth + x)] == 0x1234) continue;
      changed = {std::min(changed.left, x), std::min(changed.top, y), std::max(changed.right, x + 1),
                 std::max(changed.bottom, y + 1)};
    }
  }
  CHECK((drawn.left <= changed.left && drawn.left >= changed.left - 1));
  CHECK((drawn.top <= changed.top && drawn.top >= changed.top - 1));
  CHECK((drawn.right >= changed.right && drawn.right <= changed.right + 1));
  CHECK((drawn.bottom >= changed.bottom && drawn.bottom <= changed.bottom + 1));
}

TEST_CASE("a pixel leads to its object, and a point to its pixel") {
  Balls balls;
  arcspan_picked picked{1, 2, 3, 4};
  CHECK(arcspan_pick(balls.view, 10, 10, &picked) == ARCSPAN_NOT_READY);
  CHECK(picked.found == 0);
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  for (const auto& [object, at] :
       {std::pair{balls.left, arcspan_point{ARCSPAN_LENGTH(-0.7), 0, 0}},
        std::pair{balls.right, arcspan_point{ARCSPAN_LENGTH(0.7), ARCSPAN_LENGTH(0.2), 0}}}) {
    const arcspan_screen_point middle = arcspan_project(balls.view, at);
    CHECK(middle.in_picture == 1);
    REQUIRE(arcspan_pick(balls.view, middle.x / 16, middle.y / 16, &picked) == ARCSPAN_OK);
    CHECK(picked.found == 1);
    CHECK(picked.object == object);
    CHECK(picked.part == 0);
    CHECK(picked.triangle < 224);
  }
  REQUIRE(arcspan_pick(balls.view, 0, 0, &picked) == ARCSPAN_OK);
  CHECK(picked.found == 0);
  CHECK(arcspan_project(balls.view, {0, 0, ARCSPAN_LENGTH(5)}).in_picture == 0);
}

TEST_CASE("memory that is too small by a byte is refused") {
  const arcspan_scene_limits limits{3, 1};
  std::vector<unsigned char> memory(arcspan_scene_bytes(&limits) + 8);
  arcspan_scene* scene = nullptr;
  CHECK(arcspan_scene_make(memory.data(), arcspan_scene_bytes(&limits) - 1, &limits, &scene) ==
        ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(arcspan_scene_make(nullptr, 100000, &limits, &scene) == ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(scene == nullptr);
  for (std::size_t offset = 0; offset < 8; ++offset) {  // at any address; sanitizers see what is beyond
    CHECK(arcspan_scene_make(memory.data() + offset, arcspan_scene_bytes(&limits), &limits, &scene) ==
          ARCSPAN_OK);
  }
  const arcspan_view_limits view_limits{1, 100, 0};
  std::vector<unsigned char> view_memory(arcspan_view_bytes(&view_limits));
  arcspan_view* view = nullptr;
  CHECK(arcspan_view_make(view_memory.data(), view_memory.size() - 1, &view_limits, scene, &view) ==
        ARCSPAN_BUFFER_TOO_SMALL);
}

TEST_CASE("a view with too little room for objects or vertices says so, and the next frame is right") {
  Balls balls;
  const arcspan_view_limits enough = arcspan_limits_of(balls.scene, 0);
  std::vector<std::uint16_t> pixels(kWidth * kHeight, 0x1234), depths;
  const arcspan_target target =
      whole_target(pixels.data(), 2 * pixels.size(), 2 * kWidth, ARCSPAN_RGB565, depths);
  CHECK(arcspan_draw(balls.view, &target) == ARCSPAN_NOT_READY);
  balls.make_view({1, enough.vertices, 0});
  CHECK(arcspan_prepare(balls.view) == ARCSPAN_TOO_MANY_OBJECTS);
  CHECK(arcspan_draw(balls.view, &target) == ARCSPAN_TOO_MANY_OBJECTS);
  CHECK(pixels == std::vector<std::uint16_t>(kWidth * kHeight, 0x1234));
  REQUIRE(arcspan_set_visible(balls.scene, balls.right, 0) == ARCSPAN_OK);
  CHECK(arcspan_prepare(balls.view) == ARCSPAN_OK);
  CHECK(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
  REQUIRE(arcspan_set_visible(balls.scene, balls.right, 2) == ARCSPAN_OK);  // any number but 0
  CHECK(arcspan_prepare(balls.view) == ARCSPAN_TOO_MANY_OBJECTS);
  balls.make_view({2, enough.vertices / 4, 0});  // other methods have larger vertices
  CHECK(arcspan_prepare(balls.view) == ARCSPAN_CACHE_TOO_SMALL);
}

TEST_CASE("targets that do not fit their memory are refused") {
  Balls balls;
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  std::vector<std::uint16_t> pixels(kWidth * kHeight), depths;
  const arcspan_target right =
      whole_target(pixels.data(), 2 * pixels.size(), 2 * kWidth, ARCSPAN_RGB565, depths);
  const auto status_with = [&](auto change) {
    arcspan_target target = right;
    change(target);
    return arcspan_draw(balls.view, &target);
  };
  CHECK(status_with([](arcspan_target&) {}) == ARCSPAN_OK);
  CHECK(status_with([](arcspan_target& t) { --t.bytes; }) == ARCSPAN_BUFFER_TOO_SMALL);
  std::fill(pixels.begin(), pixels.end(), std::uint16_t{0x1234});
  CHECK(status_with([](arcspan_target& t) { --t.depth_words; }) == ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(pixels == std::vector<std::uint16_t>(kWidth * kHeight, 0x1234));
  CHECK(status_with([](arcspan_target& t) { t.stride = 2 * kWidth - 2; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_with([](arcspan_target& t) { t.stride = -2 * kWidth; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_with([](arcspan_target& t) { t.held.left = -1; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_with([](arcspan_target& t) { t.pixels = nullptr; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_with([](arcspan_target& t) { t.depth = nullptr; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_with([](arcspan_target& t) {
          t.depth = reinterpret_cast<std::uint16_t*>(reinterpret_cast<std::uintptr_t>(t.depth) + 1);
        }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_with([](arcspan_target& t) { t.format = ARCSPAN_RGB888; }) == ARCSPAN_UNSUPPORTED);
  CHECK(status_with([](arcspan_target& t) { t.format = 200; }) == ARCSPAN_UNSUPPORTED);
  CHECK(arcspan_depth_words({0, 0, 32767, 2}) == 65534);
  CHECK(arcspan_depth_words({0, 0, 2, 32767}) == 65534);
  for (const arcspan_rect& none :
       {arcspan_rect{0, 0, 32768, 1}, {0, 0, 1, 32768}, {0, -1, 2, 2}, {3, 0, 3, 2}})
    CHECK(arcspan_depth_words(none) == 0);
  CHECK(std::string(arcspan_status_text(ARCSPAN_UNSUPPORTED)) == "unsupported");
  CHECK(std::string(arcspan_status_text(255)) == "unknown status");
}

TEST_CASE("headers and libraries have the version of the project") {
  CHECK(std::string(arcspan_version()) == ARCSPAN_PROJECT_VERSION);
  CHECK(std::string(arcspan::version()) == ARCSPAN_PROJECT_VERSION);
  CHECK(std::string(ARCSPAN_VERSION_TEXT) == ARCSPAN_PROJECT_VERSION);
  CHECK(std::to_string(ARCSPAN_VERSION / 10000) + "." + std::to_string(ARCSPAN_VERSION / 100 % 100) + "." +
            std::to_string(ARCSPAN_VERSION % 100) ==
        ARCSPAN_PROJECT_VERSION);
}

TEST_CASE("lights that are not compiled or out of range change nothing") {
  Balls balls;
  const arcspan_light good{{0, 0, 1}, 0, 32768, kWhiteLight};
  const auto status_of = [&](auto change) {
    arcspan_light light = good;
    change(light);
    return arcspan_set_lights(balls.scene, &light, 1, kWhiteLight);
  };
  CHECK(status_of([](arcspan_light& l) { l.at = {0, 0, 0}; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_of([](arcspan_light& l) { l.strength = 32769; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_of([](arcspan_light& l) { l.colour.g = 40000; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_of([](arcspan_light& l) { l.half = 65536; }) == ARCSPAN_UNSUPPORTED);
  CHECK(status_of([](arcspan_light& l) { l.half = -1; }) == ARCSPAN_INVALID_ARGUMENT);
  const arcspan_light two[] = {good, good};
  CHECK(arcspan_set_lights(balls.scene, two, 2, kWhiteLight) == ARCSPAN_UNSUPPORTED);
  CHECK(arcspan_set_lights(balls.scene, &good, 1, {32769, 0, 0}) == ARCSPAN_INVALID_ARGUMENT);
  std::vector<std::uint16_t> pixels(kWidth * kHeight), depths;
  const arcspan_target target =
      whole_target(pixels.data(), 2 * pixels.size(), 2 * kWidth, ARCSPAN_RGB565, depths);
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  REQUIRE(arcspan_draw(balls.view, &target) == ARCSPAN_OK);
  CHECK(pixels == drawn_by_cpp<Rgb565>());
  // Materials in flash are for full white light where there is one light.
  REQUIRE(status_of([](arcspan_light& l) { l.strength = 16384; }) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(balls.view) == ARCSPAN_OK);
  CHECK(arcspan_draw(balls.view, &target) == ARCSPAN_LIGHT_CHANGED);
}

TEST_CASE("a model in flash whose method is not compiled is refused") {
  static constexpr auto kGouraud =
      PreparedMaterial<Gouraud<c::Light>>::of(plastic({255, 255, 255}), {c::kModelLights});
  const c::ModelPart parts[] = {ball.parts[0], {ball.parts[0].make_view, ball.parts[0].sphere, &kGouraud}};
  const arcspan_model model{parts, 2};
  const arcspan_scene_limits limits{2, 0};
  std::vector<unsigned char> memory(arcspan_scene_bytes(&limits));
  arcspan_scene* scene = nullptr;
  REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &limits, &scene) == ARCSPAN_OK);
  CHECK(arcspan_add_model(scene, &model, nullptr) == ARCSPAN_UNSUPPORTED);
  CHECK(arcspan_limits_of(scene, 0).objects == 0);
}

TEST_CASE("cameras out of range are refused, and the last one stays") {
  Balls balls;
  const auto status_of = [&](auto change) {
    arcspan_lens lens = kLens;
    change(lens);
    return arcspan_set_camera(balls.view, &lens, kEye, {0, 0, 0}, {0, 0, 0});
  };
  CHECK(status_of([](arcspan_lens& l) { l.width = 0; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_of([](arcspan_lens& l) { l.height = 2049; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_of([](arcspan_lens& l) { l.angle = 40000; }) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(status_of([](arcspan_lens& l) { l.angle = 0; }) ==
        ARCSPAN_INVALID_ARGUMENT);  // parallel, of extent 0
  CHECK(status_of([](arcspan_lens& l) { l.farthest = l.nearest; }) != ARCSPAN_OK);
  CHECK(arcspan_set_camera(balls.view, &kLens, kEye, kEye, {0, 0, 0}) != ARCSPAN_OK);
  CHECK(arcspan_prepare(balls.view) == ARCSPAN_OK);
  CHECK(status_of([](arcspan_lens& l) { l.angle = 0, l.extent = ARCSPAN_LENGTH(3); }) == ARCSPAN_OK);
}

TEST_CASE("an object has a box in the world, and no character unless they are compiled") {
  Balls balls;
  arcspan_box box{};
  REQUIRE(arcspan_bounds(balls.scene, balls.right, &box) == ARCSPAN_OK);
  const std::int32_t slack = ARCSPAN_LENGTH(0.002);
  CHECK(std::abs(box.least.x - ARCSPAN_LENGTH(0.7 - 0.75)) < slack);
  CHECK(std::abs(box.most.x - ARCSPAN_LENGTH(0.7 + 0.75)) < slack);
  CHECK(std::abs(box.least.y - ARCSPAN_LENGTH(0.2 - 0.75)) < slack);
  CHECK(std::abs(box.most.z - ARCSPAN_LENGTH(0.75)) < slack);
  REQUIRE(arcspan_set_position(balls.scene, balls.right, {INT32_MAX, 0, INT32_MIN}) == ARCSPAN_OK);
  REQUIRE(arcspan_bounds(balls.scene, balls.right, &box) == ARCSPAN_OK);
  CHECK((box.most.x == INT32_MAX && box.least.z == INT32_MIN));
  CHECK(arcspan_bounds(balls.scene, 2, &box) == ARCSPAN_INVALID_ARGUMENT);
  arcspan_character* none = nullptr;
  unsigned char memory[100];
  CHECK(arcspan_character_bytes(memory, sizeof memory) == 0);
  CHECK(arcspan_add_character(balls.scene, memory, sizeof memory, nullptr, memory, sizeof memory, &none) ==
        ARCSPAN_UNSUPPORTED);
}

TEST_CASE("objects beyond the limits of a scene are refused") {
  Balls balls;
  arcspan_object third = 77;
  CHECK(arcspan_add_model(balls.scene, &ball, &third) == ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(third == 77);
  CHECK(arcspan_set_position(balls.scene, 2, {0, 0, 0}) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_set_scale(balls.scene, balls.left, 63) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_set_scale(balls.scene, balls.left, 64) == ARCSPAN_OK);
  const arcspan_model empty{nullptr, 0};
  CHECK(arcspan_add_model(balls.scene, &empty, nullptr) == ARCSPAN_INVALID_ARGUMENT);
}

}  // namespace
