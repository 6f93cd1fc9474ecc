// SPDX-License-Identifier: MIT
// The example in the comment of PixelSink is a complete sink: it compiles, draw_mesh() draws into it, and the
// comment is the text below.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <fstream>
#include <string>

using namespace arcspan;

namespace {

struct GreyPicture {
  using Format = Gray8;
  static constexpr std::int32_t kWidth = 64;
  static constexpr std::int32_t kHeight = 48;

  [[nodiscard]] Rect bounds() const { return {0, 0, kWidth, kHeight}; }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {pixels[run.y], run.x}; }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

  std::uint8_t pixels[kHeight][kWidth] = {};
};

static_assert(PixelSink<GreyPicture> && !SinkInMemory<GreyPicture>);

/// The lines of a file that begin with `margin`, without it, from the first that has `struct GreyPicture` to
/// the closing brace.
std::string example_in(const std::string& path, const std::string& margin) {
  std::ifstream file(path);
  std::string text;
  for (std::string line; std::getline(file, line);) {
    const bool within = line.compare(0, margin.size(), margin) == 0;
    const std::string code = within ? line.substr(margin.size()) : "";
    if (text.empty() && code != "struct GreyPicture {") continue;
    text += code + "\n";
    if (code == "};") return text;
  }
  return {};
}

using Light = Illumination<1, Highlight::kBlinn>;

/// A triangle across the picture's left and lower sides, flat and lit from the eye.
template <class Sink>
DrawResult draw_triangle(Sink& sink) {
  const std::array<ObjectPosition, 3> positions{{{-9000, -6000, 0}, {4000, -7000, 0}, {0, 5000, 0}}};
  const PackedNormal towards_eye = pack_normal(0, 0, 1);
  const std::array<PackedNormal, 3> normals{towards_eye, towards_eye, towards_eye};
  const std::array<std::uint8_t, 3> indices{0, 1, 2};
  MeshView mesh;
  REQUIRE(ok(MeshView::make(positions, normals, indices, mesh)));
  ClipTransform camera;
  REQUIRE(ok(ClipTransform::make({Rotation::identity(), {{}, {}, ObjectLength::of(-20000)}},
                                 {PixelLength::of(100), ObjectLength::of(1000), ObjectLength::of(40000)},
                                 {GreyPicture::kWidth, GreyPicture::kHeight}, camera)));
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  Light light;
  REQUIRE(ok(Light::make({{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {}, 8}, {{{normalised(0, 0, 1)}}},
                         normalised(0, 0, 1), light)));
  return draw_mesh<Flat<Light>>(mesh, camera, light, sink, NoDepth{});
}

}  // namespace

TEST_CASE("the sink in the comment of PixelSink is the one that is tested here") {
  const std::string folder = ARCSPAN_SOURCE_DIR;
  const std::string shown = example_in(folder + "/pipeline/arcspan/pixel/sink.hpp", "///     ");
  const std::string tested = example_in(folder + "/tests/pipeline/pixel/smallest_sink_test.cpp", "");
  CHECK(shown.find("open(const Span& run)") != std::string::npos);
  CHECK(shown == tested);
}

TEST_CASE("the smallest sink takes the pixels that a framebuffer takes") {
  GreyPicture picture;
  std::array<std::uint8_t, GreyPicture::kWidth * GreyPicture::kHeight> memory{};
  hal::Framebuffer<Gray8> framebuffer(memory, GreyPicture::kWidth, GreyPicture::kHeight);
  CHECK(draw_triangle(picture).triangles == 1);
  CHECK(draw_triangle(framebuffer).triangles == 1);
  std::size_t drawn = 0;
  bool same = true;
  for (std::size_t i = 0; i < memory.size(); ++i) {
    same = same && picture.pixels[i / GreyPicture::kWidth][i % GreyPicture::kWidth] == memory[i];
    drawn += static_cast<std::size_t>(memory[i] != 0);
  }
  CHECK(same);
  CHECK(drawn > 500);
  CHECK(drawn < memory.size());
}

namespace {

/// Refuses its third run, and notes the calls.
struct RefusingPicture : GreyPicture {
  static constexpr int kTaken = 2;
  int opened = 0;
  int closed = 0;
  Span run;

  [[nodiscard]] Format::Cursor open(const Span& next) {
    CHECK(opened == closed);
    ++opened;
    run = next;
    return GreyPicture::open(next);
  }
  [[nodiscard]] Status close(const Span& finished) {
    ++closed;
    CHECK(finished == run);
    CHECK(finished.count > 0);
    CHECK((finished.x >= 0 && finished.x + finished.count <= kWidth));
    CHECK((finished.y >= 0 && finished.y < kHeight));
    return closed > kTaken ? Status::kTransferFailed : Status::kOk;
  }
};

}  // namespace

TEST_CASE("every run is opened and closed, and the first refusal ends the drawing") {
  RefusingPicture picture;
  CHECK(draw_triangle(picture).status == Status::kTransferFailed);
  CHECK(picture.opened == RefusingPicture::kTaken + 1);
  CHECK(picture.closed == RefusingPicture::kTaken + 1);
}
