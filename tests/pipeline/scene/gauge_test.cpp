// SPDX-License-Identifier: MIT
// A gauge whose needle moves: what is drawn and sent of it, against the whole frame.
#include <arcspan/drawn_rect.hpp>
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/hal/sim/simulated_bus.hpp>
#include <arcspan/pixel/background.hpp>
#include <arcspan/scene.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kRows = 16;
constexpr Rgb8 kGround{0, 0, 40};
constexpr std::size_t kTicks = 24;

/// `p` turned to the right, in object units.
constexpr ObjectPosition at_turn(std::int32_t x, std::int32_t y, Turn turn) {
  const std::int64_t s = sine(turn).raw();
  const std::int64_t c = cosine(turn).raw();
  return {static_cast<std::int16_t>((c * x + s * y) >> 30), static_cast<std::int16_t>((c * y - s * x) >> 30),
          0};
}

/// A dial of ticks around the origin, and a needle that points up.
struct Gauge {
  std::array<ObjectPosition, 4 * kTicks> ticks{};
  std::array<PackedNormal, 4 * kTicks> normals{};
  std::array<std::uint8_t, 6 * kTicks> faces{};
  std::array<ObjectPosition, 3> needle{{{-1200, -4000, 0}, {1200, -4000, 0}, {0, 29000, 0}}};
  std::array<std::uint8_t, 3> needle_face{0, 1, 2};
  MeshView dial_mesh;
  MeshView needle_mesh;

  Gauge() {
    for (std::size_t i = 0; i < kTicks; ++i) {
      const Turn turn{static_cast<std::uint16_t>(65536 * i / kTicks)};
      const auto at = static_cast<std::uint8_t>(4 * i);
      ticks[at] = at_turn(-600, 24000, turn);
      ticks[at + 1u] = at_turn(600, 24000, turn);
      ticks[at + 2u] = at_turn(600, 32000, turn);
      ticks[at + 3u] = at_turn(-600, 32000, turn);
      const int corners[] = {0, 1, 2, 0, 2, 3};
      for (std::size_t k = 0; k < 6; ++k) faces[6 * i + k] = static_cast<std::uint8_t>(at + corners[k]);
    }
    REQUIRE(ok(MeshView::make(ticks, normals, faces, dial_mesh)));
    REQUIRE(ok(MeshView::make(needle, std::span(normals).first(3), needle_face, needle_mesh)));
  }
};

constexpr PreparedMaterial<Unlit> kPaint{Unlit::lighting({250, 250, 250})};
constexpr PreparedMaterial<Unlit> kNeedle{Unlit::lighting({240, 40, 20})};

std::int64_t pixels(const Rect& r) { return r.empty() ? 0 : std::int64_t{r.width()} * r.height(); }

/// The gauge on a panel of 240x320 pixels.
struct GaugeBench {
  using Mode = hal::PageMode<hal::Ili9341>;
  using Memory = SceneMemory<MethodList<Unlit>, 2, 4 * kTicks + 3>;

  hal::sim::SimulatedClock clock;
  hal::sim::DcsModel device{hal::kIli9341Module};
  hal::sim::SimulatedSpi bus{device, clock, 20'000'000};
  hal::Ili9341 panel{bus, bus.dc, &bus.reset, clock, hal::kIli9341Module, {}};
  Gauge gauge;
  std::vector<std::uint16_t> band = std::vector<std::uint16_t>(240 * kRows);
  std::vector<std::uint8_t> wire = std::vector<std::uint8_t>(2 * 240 * kRows);
  std::vector<std::uint16_t> depths = std::vector<std::uint16_t>(240 * kRows);
  Mode mode{panel, band, wire, kRows};
  Camera camera;
  std::vector<Object> objects;
  Memory memory;
  Rect shown{};             ///< of the needle on the glass
  std::int64_t drawn = 0;   ///< pixels of all windows
  std::uint64_t bytes = 0;  ///< that the last frame sent
  static constexpr std::uint64_t kWholeBytes = 2 * 240 * 320;

  GaugeBench() {
    REQUIRE(Camera::make({WorldPoint::of(0, 0, 4), {}},
                         Lens::orthographic(WorldLength::of(2.8), WorldLength::of(1), WorldLength::of(8)),
                         {240, 320}, camera) == Status::kOk);
    objects.emplace_back(gauge.dial_mesh, kPaint);
    objects.emplace_back(gauge.needle_mesh, kNeedle, WorldPoint::of(0, 0, 0.1));
    REQUIRE(panel.start() == Status::kOk);
    prepare({});
    const Rect all = panel.bounds();
    REQUIRE(mode.show_area(all, [&](auto& window) { return draw_all(window); }) == Status::kOk);
    shown = drawn_rect(memory, objects[1]);
  }
  void prepare(Turn turn) {
    objects[1].rotation = rotation_of(EulerAngles{.yaw = {}, .pitch = {}, .roll = turn});
    REQUIRE(ok(prepare_scene({camera, {}, objects}, memory)));
  }
  Status draw_all(Mode::Window& window) {
    drawn += pixels(window.bounds());
    const DepthBuffer depth(depths, window.bounds());
    return draw_prepared_scene(memory, window, depth, kGround).status;
  }
  /// Moves the needle; `draw` draws a window. Returns the pixels of its rectangles before and now.
  template <class Draw>
  std::int64_t move(Turn turn, const Draw& draw) {
    prepare(turn);
    const Rect now = drawn_rect(memory, objects[1]);
    const std::int64_t both = pixels(shown) + pixels(now);
    const std::uint64_t before = bus.count().bytes;
    drawn = 0;
    REQUIRE(mode.show_areas(shown, now, draw) == Status::kOk);
    bytes = bus.count().bytes - before;
    shown = now;
    return both;
  }
  /// Compares the glass with a frame that is drawn as a whole.
  void check_glass() {
    std::vector<std::uint16_t> words(240 * 320);
    std::vector<std::uint16_t> all_depths(240 * 320);
    hal::Framebuffer<Rgb565> whole(words, 240, 320);
    const DepthBuffer depth(all_depths, 240, 320);
    REQUIRE(ok(draw_prepared_scene(memory, whole, depth, kGround).status));
    const hal::sim::Picture glass = device.picture();
    std::size_t equal = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
      equal += glass.pixels[i] == Rgb565::decode(words[i]) ? 1u : 0u;
    REQUIRE(equal == words.size());
    REQUIRE(device.complaints().empty());
    REQUIRE(bus.complaints().empty());
  }
};

// What a window takes on the bus besides its pixels.
constexpr std::uint64_t kWindowBytes = 16;

}  // namespace

TEST_CASE("a needle that moves sends and draws at most twice its rectangle") {
  GaugeBench test;
  test.check_glass();
  std::uint64_t most = 0;
  const int frames = share_of(200);
  for (int i = 1; i <= frames; ++i) {
    // Slowly, then in leaps of 53 degrees.
    const auto turn = static_cast<std::uint16_t>(i <= frames / 2 ? 650 * i : 9600 * i);
    const std::int64_t both = test.move({turn}, [&](auto& window) { return test.draw_all(window); });
    CHECK(test.drawn <= both);
    CHECK(test.bytes <= 2 * static_cast<std::uint64_t>(both) + 8 * kWindowBytes);
    most = std::max(most, test.bytes);
    test.check_glass();
  }
  CHECK(most < GaugeBench::kWholeBytes / 5);
}

TEST_CASE("a dial that was drawn once is copied from its picture") {
  GaugeBench test;
  std::vector<std::uint16_t> dial_words(240 * 320);
  std::vector<std::uint16_t> dial_depths(240 * 320);
  hal::Framebuffer<Rgb565> dial(dial_words, 240, 320);
  const DepthBuffer dial_depth(dial_depths, 240, 320);
  GaugeBench::Memory dial_memory;
  REQUIRE(ok(
      draw_scene({test.camera, {}, std::span(test.objects).first(1)}, dial, dial_depth, dial_memory, kGround)
          .status));
  const BackgroundPicture<Rgb565> picture{dial_words, 240, 320};
  GaugeBench::Memory needle_memory;
  for (int i = 1; i <= share_of(60); ++i) {
    const Turn turn{static_cast<std::uint16_t>(1900 * i)};
    test.prepare(turn);
    REQUIRE(ok(prepare_scene({test.camera, {}, std::span(test.objects).subspan(1)}, needle_memory)));
    std::uint32_t objects = 0;
    const std::int64_t both = test.move(turn, [&](auto& window) {
      const DepthBuffer depth(test.depths, window.bounds());
      test.drawn += pixels(window.bounds());
      const SceneResult result = draw_prepared_scene(needle_memory, window, depth, picture);
      objects += result.objects;
      return result.status;
    });
    CHECK(objects > 0);
    CHECK(test.drawn <= both);
    test.check_glass();
  }
}
