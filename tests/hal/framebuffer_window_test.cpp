// SPDX-License-Identifier: MIT
// A window in a larger picture: it takes the pixels that a framebuffer of its own would, and leaves the rest.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/pixel/gray2.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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
  const std::size_t offset = static_cast<std::size_t>(kTop * around.stride_bytes()) +
                             TestType::words_per_row(kLeft) * sizeof(typename TestType::Word);
  const auto bytes = std::as_writable_bytes(std::span(memory)).subspan(offset);
  FramebufferWindow<TestType> window(bytes, {0, 0, kWidth, kHeight}, around.stride_bytes());
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

TEST_CASE("a window has the pixels of its columns, and moves to other rows") {
  std::array<std::uint16_t, 20> memory{};
  const auto bytes = std::as_writable_bytes(std::span(memory)).subspan(2);
  FramebufferWindow<Rgb565> window(bytes, {7, 10, 10, 12}, 10);
  REQUIRE(ok(window.status()));
  CHECK(window.bounds() == Rect{7, 10, 10, 12});
  for (const std::int32_t row : {-1, INT32_MAX - 1}) {
    window.move_to(row);
    CHECK(window.status() == Status::kInvalidArgument);
    CHECK(window.bounds().empty());
  }
  window.move_to(4);
  CHECK(window.status() == Status::kOk);
  CHECK(window.bounds() == Rect{7, 4, 10, 6});
  window.open({5, 9, 1}).write(0x1234);
  CHECK(memory[1 + 5 + 2] == 0x1234);
  CHECK(window.row(5)[9] == 0x1234);
  CHECK(window.pixel(9, 5) == Rgb565::decode(0x1234));
}

TEST_CASE("rows of three-byte pixels may begin at any byte") {
  std::array<std::byte, 1 + 3 * 11 + 9> memory{};
  FramebufferWindow<Rgb888> window(std::span{memory}.subspan(1), {5, 0, 8, 4}, 11);
  REQUIRE(ok(window.status()));
  window.open({3, 6, 1}).write({1, 2, 3});
  CHECK(memory[1 + 3 * 11 + 3] == std::byte{1});
  CHECK(memory[1 + 3 * 11 + 5] == std::byte{3});
  const auto short_of = std::span(memory).subspan(2);
  CHECK(FramebufferWindow<Rgb888>(short_of, {5, 0, 8, 4}, 11).status() == Status::kBufferTooSmall);
}

TEST_CASE("several pixels of a word lie in it as in the picture") {
  std::array<std::byte, 6> memory{};
  FramebufferWindow<Mono> window(memory, {11, 2, 18, 4}, 3);  // columns 8...15 and 16...23
  REQUIRE(ok(window.status()));
  window.clear({255, 255, 255});
  using Bytes = std::array<std::byte, 6>;
  CHECK(memory == Bytes{std::byte{0x1F}, std::byte{0xC0}, {}, std::byte{0x1F}, std::byte{0xC0}, {}});
  CHECK(FramebufferWindow<Mono>(memory, {11, 2, 18, 4}, 1).status() == Status::kInvalidArgument);
  CHECK(FramebufferWindow<Mono>(memory, {11, 2, 18, 4}, 2).status() == Status::kOk);
}

TEST_CASE("a window refuses rows that overlap or that its memory does not hold") {
  alignas(4) std::array<std::byte, 40> memory{};
  const auto status = [&](std::size_t from, const Rect& held, std::int32_t stride_bytes) {
    return FramebufferWindow<Rgb565>(std::span(memory).subspan(from), held, stride_bytes).status();
  };
  CHECK(status(2, {0, 0, 4, 4}, 10) == Status::kOk);
  CHECK(status(2, {9, 7, 13, 11}, 10) == Status::kOk);
  CHECK(status(0, {0, 0, 5, 4}, 10) == Status::kOk);
  CHECK(status(0, {0, 3, 0, 9}, 0) == Status::kOk);
  CHECK(status(0, {0, 3, 4, 3}, 8) == Status::kOk);
  CHECK(status(4, {0, 0, 4, 4}, 10) == Status::kBufferTooSmall);
  CHECK(status(4, {9, 7, 13, 11}, 10) == Status::kBufferTooSmall);
  CHECK(status(0, {0, 0, 4, 4}, 12) == Status::kBufferTooSmall);
  CHECK(status(0, {0, 0, 32767, 32767}, 65534) == Status::kBufferTooSmall);
  const Rect wrong[] = {{-1, 0, 1, 1},
                        {0, -1, 1, 1},
                        {2, 0, 1, 1},
                        {0, 2, 1, 1},
                        {32767, 0, 32768, 1},
                        {0, 32767, 1, 32768},
                        {INT32_MIN, 0, INT32_MAX, 1},
                        {INT32_MIN, INT32_MIN, 0, 0}};
  for (const Rect& held : wrong) {
    CAPTURE(held.left, held.top, held.right, held.bottom);
    CHECK(status(0, held, 10) == Status::kInvalidArgument);
  }
  CHECK(status(0, {0, 0, 6, 1}, 10) == Status::kInvalidArgument);
  CHECK(status(0, {0, 0, 1, 1}, -2) == Status::kInvalidArgument);
  CHECK(status(0, {0, 0, 1, 1}, INT32_MIN) == Status::kInvalidArgument);
  CHECK(status(0, {0, 0, 4, 2}, 11) == Status::kInvalidArgument);  // Rgb565 has words of two bytes
  CHECK(status(1, {0, 0, 4, 2}, 10) == Status::kInvalidArgument);
  CHECK(status(0, {0, 0, 1, 2}, INT32_MAX - 1) == Status::kInvalidArgument);
  CHECK(status(0, {0, 0, 1, 1}, INT32_MAX - 1) == Status::kOk);
  FramebufferWindow<Rgb565> empty({}, {7, 2, 7, 9}, 0);
  empty.clear({255, 255, 255});
  CHECK(empty.status() == Status::kOk);
  FramebufferWindow<Rgb565> refused(std::span{memory}.subspan(4), {0, 0, 4, 4}, 10);
  CHECK(refused.bounds().empty());
  refused.move_to(3);
  refused.clear({255, 255, 255});
  CHECK(refused.status() == Status::kBufferTooSmall);
  CHECK(memory == std::array<std::byte, 40>{});
}
