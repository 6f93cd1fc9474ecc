// SPDX-License-Identifier: MIT
// A window in a larger picture: it takes the pixels that a framebuffer of its own would, and leaves the rest.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/pixel/gray2.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace arcspan;
using hal::Framebuffer;
using hal::FramebufferWindow;

namespace {

using Light = Illumination<1, Highlight::kBlinn>;
constexpr std::int32_t kWidth = 37;
constexpr std::int32_t kHeight = 30;
constexpr std::int32_t kLeft = 12;  // a multiple of the pixels per word of every format
constexpr std::int32_t kTop = 5;
constexpr std::int32_t kAround = 64;  // width of the whole picture
constexpr Rgb8 kBackground{0, 0, 255};
constexpr Rgb8 kOutside{255, 255, 255};

template <class Sink>
void draw_sphere(Sink& sink) {
  const auto sphere = scenes::make_sphere<8, 4>();
  MeshView mesh;
  REQUIRE(ok(sphere.view(mesh)));
  ClipTransform camera;
  REQUIRE(ok(ClipTransform::make(
      {Rotation::about_x({4551}), {{}, {}, ObjectLength::of(-4 * scenes::kRadius)}},
      {PixelLength::of(56), ObjectLength::of(32768), ObjectLength::of(98304)}, {kWidth, kHeight}, camera)));
  constexpr ChannelCoefficients kGrey{Coefficient::of(0.8), Coefficient::of(0.8), Coefficient::of(0.8)};
  Light light;
  REQUIRE(ok(Light::make({{}, kGrey, {}, 8}, {{{normalised(1, 2, 3)}}}, normalised(0, 0, 1), light)));
  sink.clear(kBackground);
  REQUIRE(ok(draw_mesh<Flat<Light>>(mesh, camera, light, sink, NoDepth{}).status));
}

}  // namespace

TEMPLATE_TEST_CASE("a window in a picture has the pixels of a framebuffer, and nothing around it changes", "",
                   Rgb565, Gray4, Gray2) {
  std::vector<typename TestType::Word> own(Framebuffer<TestType>::words(kWidth, kHeight));
  Framebuffer<TestType> expected(own, kWidth, kHeight);
  draw_sphere(expected);

  constexpr std::int32_t kRows = kTop + kHeight;  // the window ends with the picture
  std::vector<typename TestType::Word> memory(Framebuffer<TestType>::words(kAround, kRows));
  Framebuffer<TestType> around(memory, kAround, kRows);
  around.clear(kOutside);
  const hal::RowLayout layout{
      around.stride(), kTop * around.stride() + static_cast<std::int32_t>(TestType::words_per_row(kLeft))};
  FramebufferWindow<TestType> window(memory, kWidth, kHeight, layout);
  REQUIRE(ok(window.status()));
  draw_sphere(window);

  for (std::int32_t y = 0; y < kRows; ++y) {
    for (std::int32_t x = 0; x < kAround; ++x) {
      CAPTURE(x, y);
      const bool inside = x >= kLeft && x < kLeft + kWidth && y >= kTop;
      const Rgb8 wanted = inside ? expected.pixel(x - kLeft, y - kTop) : kOutside;
      REQUIRE(around.pixel(x, y) == wanted);
    }
  }
}

TEST_CASE("a window moves to other rows of the picture") {
  std::array<std::uint16_t, 20> memory{};
  FramebufferWindow<Rgb565> window(memory, 3, 2, {5, 1}, 10);
  REQUIRE(ok(window.status()));
  CHECK(window.bounds() == Rect{0, 10, 3, 12});
  window.move_to(4);
  CHECK(window.bounds() == Rect{0, 4, 3, 6});
  window.open({5, 2, 1}).write(0x1234);
  CHECK(memory[1 + 5 + 2] == 0x1234);
}

TEST_CASE("a window refuses rows that overlap or that its memory does not hold") {
  using Window = FramebufferWindow<Rgb565>;
  std::array<std::uint16_t, 20> memory{};
  CHECK(Window(memory, 4, 4, {5, 1}).status() == Status::kOk);
  CHECK(Window(memory, 5, 4, {5, 0}).status() == Status::kOk);
  CHECK(Window(memory, 4, 4, {5, 2}).status() == Status::kBufferTooSmall);
  CHECK(Window(memory, 4, 4, {6, 0}).status() == Status::kBufferTooSmall);
  CHECK(Window(memory, 6, 1, {5, 0}).status() == Status::kInvalidArgument);
  CHECK(Window(memory, 1, 1, {5, -1}).status() == Status::kInvalidArgument);
  CHECK(Window(memory, -1, 1, {5, 0}).status() == Status::kInvalidArgument);
  CHECK(Window(memory, 1, 2, {INT32_MAX, INT32_MAX}).status() == Status::kInvalidArgument);
  CHECK(Window(memory, 1, 1, {INT32_MAX, INT32_MAX - 1}).status() == Status::kBufferTooSmall);
  CHECK(Window(memory, 1, 1, {1, 0}, -1).status() == Status::kInvalidArgument);
  CHECK(Window(memory, 4, 4, {5, 2}).bounds().empty());
  Window refused(memory, 4, 4, {5, 2});
  refused.clear({255, 255, 255});
  CHECK(memory == std::array<std::uint16_t, 20>{});
}
