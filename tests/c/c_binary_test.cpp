// SPDX-License-Identifier: MIT
// Meshes and models in binaries, as `arcspan mesh` writes them, are drawn from C with the pixels of C++, or
// refused.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/model/model_neighbours.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/scene_outlines.hpp>

#include <arcspan.h>
#include <arcspan_c/compiled_methods.hpp>
#include <arcspan_c/scene.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" {
extern const arcspan_model outlined;
extern const arcspan_model stepped;
}

namespace {

using namespace arcspan;

constexpr std::int32_t kSide = 64;
constexpr arcspan_rgb kBlack = {0, 0, 0};
constexpr arcspan_lens kLens = {kSide, kSide, ARCSPAN_DEGREES(44), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(9)};
constexpr arcspan_point kEye = {ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(1.5), ARCSPAN_LENGTH(3)};

/// A file of the build folder, at an aligned address.
struct Binary {
  std::vector<std::uint32_t> words;
  std::size_t size = 0;

  explicit Binary(const std::string& name) {
    std::ifstream file(ARCSPAN_C_BINARIES + name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    REQUIRE(!bytes.empty());
    size = bytes.size();
    words.resize(size / 4 + 1);
    bytes.copy(reinterpret_cast<char*>(words.data()), size);
  }
  [[nodiscard]] unsigned char* data() { return reinterpret_cast<unsigned char*>(words.data()); }
};

/// A frame of a scene that is prepared; with outlines in memory of `outlines`, and ink.
struct OutlinedView {
  std::vector<unsigned char> memory;
  std::vector<unsigned char> outline_memory;
  arcspan_view* view = nullptr;

  OutlinedView(arcspan_scene* scene, const arcspan_outline_limits* outlines, const arcspan_ink* ink) {
    const arcspan_view_limits limits = arcspan_limits_of(scene, 0);
    memory.resize(arcspan_view_bytes(&limits));
    REQUIRE(arcspan_view_make(memory.data(), memory.size(), &limits, scene, &view) == ARCSPAN_OK);
    REQUIRE(arcspan_set_camera(view, &kLens, kEye, {0, 0, 0}, {0, 0, 0}) == ARCSPAN_OK);
    if (outlines != nullptr) {
      const std::size_t bytes = arcspan_outline_bytes(outlines);
      outline_memory.resize(bytes);
      REQUIRE(arcspan_smooth_outlines(view, outline_memory.data(), bytes - 1, outlines) ==
              ARCSPAN_BUFFER_TOO_SMALL);
      REQUIRE(arcspan_smooth_outlines(view, outline_memory.data(), bytes, outlines) == ARCSPAN_OK);
      REQUIRE(arcspan_ink_outlines(view, ink) == ARCSPAN_OK);
      // A call that is refused changes nothing.
      REQUIRE(arcspan_smooth_outlines(view, outline_memory.data(), bytes - 1, outlines) ==
              ARCSPAN_BUFFER_TOO_SMALL);
      const arcspan_outline_limits none{0, outlines->edges, outlines->gaps, outlines->curves};
      REQUIRE(arcspan_smooth_outlines(view, outline_memory.data(), bytes, &none) == ARCSPAN_INVALID_ARGUMENT);
    }
    REQUIRE(arcspan_prepare(view) == ARCSPAN_OK);
  }
};

struct Scene2 {
  std::vector<unsigned char> memory;
  arcspan_scene* scene = nullptr;

  explicit Scene2(arcspan_scene_limits limits) : memory(arcspan_scene_bytes(&limits), 0xA5) {
    REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &limits, &scene) == ARCSPAN_OK);
  }
  /// The picture, drawn in rectangles of `side` pixels; with outlines in memory of `outlines`, and ink.
  [[nodiscard]] std::vector<std::uint16_t> drawn(const arcspan_outline_limits* outlines = nullptr,
                                                 arcspan_status expected = ARCSPAN_OK,
                                                 std::int32_t side = kSide,
                                                 const arcspan_ink* ink = nullptr) const {
    const OutlinedView seen(scene, outlines, ink);
    std::vector<std::uint16_t> pixels(kSide * kSide), depths(kSide * kSide), part(kSide * kSide);
    arcspan_status first = ARCSPAN_OK;
    const std::int32_t more = ink == nullptr ? 1 : 2;
    for (std::int32_t y = 0; y < kSide; y += side) {
      for (std::int32_t x = 0; x < kSide; x += side) {
        const arcspan_rect held{std::max(x - more, 0), std::max(y - more, 0),
                                std::min(x + side + more, kSide), std::min(y + side + more, kSide)};
        const std::int32_t width = held.right - held.left;
        const arcspan_target target{part.data(), 2 * part.size(), 2 * width,     ARCSPAN_RGB565,
                                    held,        depths.data(),   depths.size(), &kBlack};
        const arcspan_status status = arcspan_draw(seen.view, &target);
        if (first == ARCSPAN_OK) first = status;
        for (std::int32_t row = y; row < std::min(y + side, held.bottom); ++row) {
          const auto begin = part.begin() + (row - held.top) * width + (x - held.left);
          std::copy(begin, begin + std::min(side, kSide - x), pixels.begin() + row * kSide + x);
        }
      }
    }
    CHECK(first == expected);
    return pixels;
  }
};

/// The parts of a model by the method M, or with a texture by T.
template <class M, class T>
std::vector<std::uint16_t> drawn_by_cpp(Binary& binary, bool smooth = false, const OutlineInk* ink = nullptr,
                                        std::int32_t toon_steps = 0, bool curved = false,
                                        [[maybe_unused]] Opacity<> opacity = {}) {
  StoredModel model;
  REQUIRE(ok(view_model_binary({binary.data(), binary.size}, model)));
  const SceneLight light = SceneLight::directional(normalised(-1, 1, 2));
  const LightList lights{{&light, 1}};
  std::vector<MeshView> meshes(model.part_count());
  std::vector<PreparedMaterial<M>> plain(model.part_count());
  std::vector<PreparedMaterial<T>> textured(model.part_count());
  std::vector<Object> objects;
  for (std::size_t i = 0; i < model.part_count(); ++i) {
    const ModelPart part = model.part(i);
    meshes[i] = part.mesh;
    if (part.texture.texels.empty()) {
      REQUIRE(ok(PreparedMaterial<M>::make(part.material, lights, {part.two_sided}, plain[i])));
      if (toon_steps != 0) REQUIRE(ok(plain[i].set_toon(toon_steps)));
      if constexpr (arcspan::detail::kBlends<M>) plain[i].set(opacity);
      objects.emplace_back(meshes[i], plain[i], part.sphere);
    } else {
      Texture<Palette8Texels<>> texture;
      REQUIRE(ok(view_texture(part.texture, texture)));
      REQUIRE(ok(PreparedMaterial<T>::make(part.material, lights, {part.two_sided}, textured[i])));
      if (toon_steps != 0) REQUIRE(ok(textured[i].set_toon(toon_steps)));
      textured[i] = textured[i].with(texture);
      if constexpr (arcspan::detail::kBlends<T>) textured[i].set(opacity);
      objects.emplace_back(meshes[i], textured[i], part.sphere);
    }
  }
  Camera camera;
  REQUIRE(
      ok(Camera::make({WorldPoint::of(1, 1.5, 3), {}},
                      Lens::field_of_view(Turn{ARCSPAN_DEGREES(44)}, WorldLength::of(1), WorldLength::of(9)),
                      {kSide, kSide}, camera)));
  using Frame = hal::Framebuffer<Rgb565>;
  std::vector<std::uint16_t> pixels(kSide * kSide), depths(kSide * kSide);
  Frame frame(pixels, kSide, kSide);
  static SceneMemory<MethodList<M, T>, 16, 1024> memory;
  const DepthBuffer depth(depths, kSide, kSide);
  const Scene scene{camera, lights, objects};
  if (!smooth) {
    REQUIRE(ok(draw_scene(scene, frame, depth, memory, Rgb8{}).status));
    return pixels;
  }
  std::vector<MeshNeighbours> neighbours(model.part_count());
  std::vector<OutlinedMesh> outlined;
  for (std::size_t i = 0; i < model.part_count(); ++i) {
    REQUIRE(ok(view_neighbours(model, i, neighbours[i])));
    outlined.push_back({&meshes[i], &neighbours[i]});
  }
  std::vector<TriangleSide> sides(2000);
  std::vector<OutlineEdge> edges(2000);
  std::vector<OutlineGap<Rgb565>> gaps(2000);
  if (curved) {
    CurveMemory<200> curves;
    SceneOutlines<Rgb565, CurvedOutlines> outlines{outlined, sides, OutlineList(edges), gaps,
                                                   CurvedOutlines(curves)};
    REQUIRE(ok(draw_scene(scene, frame, depth, memory, Rgb8{}, outlines).status));
    return pixels;
  }
  SceneOutlines<Rgb565> outlines{outlined, sides, OutlineList(edges), gaps};
  const SceneResult result = ink == nullptr ? draw_scene(scene, frame, depth, memory, Rgb8{}, outlines)
                                            : draw_scene(scene, frame, depth, memory, Rgb8{}, outlines, *ink);
  REQUIRE(ok(result.status));
  return pixels;
}

TEST_CASE("models in binaries are drawn from C with the pixels of C++") {
  using Smooth = Arc<c::Light>;
  using Faceted = Flat<c::Light>;
  for (const char* const name : {"lamp.bin", "sign.bin"}) {
    CAPTURE(name);
    Binary binary(name);
    Scene2 smooth({16, 16});
    REQUIRE(arcspan_add_binary(smooth.scene, binary.data(), binary.size, nullptr, nullptr) == ARCSPAN_OK);
    CHECK((smooth.drawn() == drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(binary)));
    Scene2 faceted({16, 16});
    const arcspan_look look{ARCSPAN_FLAT, 1, 0, nullptr, 0};
    REQUIRE(arcspan_add_binary(faceted.scene, binary.data(), binary.size, &look, nullptr) == ARCSPAN_OK);
    CHECK((faceted.drawn() == drawn_by_cpp<Faceted, Textured<Faceted, Palette8Texels<>>>(binary)));
  }
  Binary ball("ball.bin");
  const arcspan_look look{ARCSPAN_FLAT, 1, 0, nullptr, 0};
  Scene2 smooth({1, 1});
  Scene2 faceted({1, 1});
  REQUIRE(arcspan_add_binary(smooth.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
  REQUIRE(arcspan_add_binary(faceted.scene, ball.data(), ball.size, &look, nullptr) == ARCSPAN_OK);
  CHECK((faceted.drawn() != smooth.drawn()));
}

TEST_CASE("outlines are smoothed from C as from C++, whole and in rectangles") {
  using Smooth = Arc<c::Light>;
  const arcspan_outline_limits limits{2000, 2000, 2000, 0};
  Binary lamp("outlined-lamp.bin");
  const auto expected = drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(lamp, true);
  Scene2 stored({16, 16});
  REQUIRE(arcspan_add_binary(stored.scene, lamp.data(), lamp.size, nullptr, nullptr) == ARCSPAN_OK);
  const auto plain = stored.drawn();
  CHECK(plain != expected);
  CHECK(stored.drawn(&limits) == expected);
  CHECK(stored.drawn(&limits, ARCSPAN_OK, 20) == expected);
  Scene2 in_flash({16, 0});
  REQUIRE(arcspan_add_model(in_flash.scene, &outlined, nullptr) == ARCSPAN_OK);
  CHECK(in_flash.drawn(&limits, ARCSPAN_OK, 20) != in_flash.drawn());

  const arcspan_outline_limits few_triangles{3, 2000, 2000, 0};
  CHECK(stored.drawn(&few_triangles, ARCSPAN_BUFFER_TOO_SMALL) != expected);
  const arcspan_outline_limits no_edges{2000, 0, 2000, 0};
  CHECK(stored.drawn(&no_edges, ARCSPAN_BUFFER_TOO_SMALL) == plain);
  const arcspan_outline_limits no_gaps{2000, 2000, 0, 0};
  CHECK(stored.drawn(&no_gaps, ARCSPAN_BUFFER_TOO_SMALL) == plain);
  for (const char* const name : {"lamp.bin", "ball.bin"}) {
    CAPTURE(name);
    Binary without(name);
    Scene2 scene({16, 16});
    REQUIRE(arcspan_add_binary(scene.scene, without.data(), without.size, nullptr, nullptr) == ARCSPAN_OK);
    CHECK(scene.drawn(&limits, ARCSPAN_UNSUPPORTED) == scene.drawn());
  }
}

TEST_CASE("outlines are rounded from C as from C++, whole and in rectangles") {
  using Smooth = Arc<c::Light>;
  const arcspan_outline_limits straight{2000, 2000, 2000, 0};
  const arcspan_outline_limits rounded{2000, 2000, 2000, 200};
  const arcspan_outline_limits too_few{2000, 2000, 2000, 2};
  Binary ball("curved-ball.bin");
  const auto expected =
      drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(ball, true, nullptr, 0, true);
  Scene2 scene({1, 1});
  REQUIRE(arcspan_add_binary(scene.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
  CHECK(scene.drawn(&straight) == drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(ball, true));
  CHECK(scene.drawn(&straight) != expected);
  CHECK(scene.drawn(&rounded) == expected);
  CHECK(scene.drawn(&rounded, ARCSPAN_OK, 20) == expected);
  CHECK(scene.drawn(&too_few, ARCSPAN_BUFFER_TOO_SMALL) != expected);
}

TEST_CASE("outlines are inked from C as from C++, whole and in rectangles") {
  using Smooth = Arc<c::Light>;
  const arcspan_outline_limits limits{2000, 2000, 2000, 0};
  Binary lamp("outlined-lamp.bin");
  Scene2 scene({16, 16});
  REQUIRE(arcspan_add_binary(scene.scene, lamp.data(), lamp.size, nullptr, nullptr) == ARCSPAN_OK);
  const auto smooth = scene.drawn(&limits);
  for (const bool creases : {false, true}) {
    CAPTURE(creases);
    const auto width = static_cast<std::uint8_t>(creases ? 1 : 4);
    const OutlineInk ink{{200, 40, 90}, width, creases};
    const auto expected = drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(lamp, true, &ink);
    CHECK(expected != smooth);
    const arcspan_ink of_c{{200, 40, 90}, width, static_cast<std::uint8_t>(creases)};
    CHECK(scene.drawn(&limits, ARCSPAN_OK, kSide, &of_c) == expected);
    CHECK(scene.drawn(&limits, ARCSPAN_OK, 20, &of_c) == expected);
    const arcspan_outline_limits no_gaps{2000, 2000, 0, 0};
    CHECK(scene.drawn(&no_gaps, ARCSPAN_BUFFER_TOO_SMALL, kSide, &of_c) == scene.drawn());
  }
}

TEST_CASE("ink is refused without memory or out of range, and ends with smoothing") {
  const arcspan_outline_limits limits{2000, 2000, 2000, 0};
  Binary lamp("outlined-lamp.bin");
  Scene2 scene({16, 16});
  REQUIRE(arcspan_add_binary(scene.scene, lamp.data(), lamp.size, nullptr, nullptr) == ARCSPAN_OK);
  arcspan_ink ink{{200, 40, 90}, 2, 0};
  const OutlinedView without(scene.scene, nullptr, nullptr);
  CHECK(arcspan_ink_outlines(without.view, &ink) == ARCSPAN_NOT_READY);
  OutlinedView seen(scene.scene, &limits, nullptr);
  for (const int width : {0, 5, 255}) {
    ink.width = static_cast<std::uint8_t>(width);
    CHECK(arcspan_ink_outlines(seen.view, &ink) == ARCSPAN_INVALID_ARGUMENT);
  }
  // A format of one bit has ink, but is not smoothed.
  std::vector<std::uint8_t> bits(kSide * kSide / 8);
  std::vector<std::uint16_t> depths(kSide * kSide);
  const arcspan_target target{bits.data(),          bits.size(),   kSide / 8,     ARCSPAN_MONO,
                              {0, 0, kSide, kSide}, depths.data(), depths.size(), &kBlack};
  CHECK(arcspan_draw(seen.view, &target) == ARCSPAN_UNSUPPORTED);
  const auto plain = bits;
  ink = {{255, 255, 255}, 2, 0};
  REQUIRE(arcspan_ink_outlines(seen.view, &ink) == ARCSPAN_OK);
  CHECK(arcspan_draw(seen.view, &target) == ARCSPAN_OK);
  CHECK(bits != plain);
  // Other memory keeps the ink, no memory ends it.
  REQUIRE(arcspan_smooth_outlines(seen.view, seen.outline_memory.data(), seen.outline_memory.size(),
                                  &limits) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(seen.view) == ARCSPAN_OK);
  const auto inked = bits;
  CHECK(arcspan_draw(seen.view, &target) == ARCSPAN_OK);
  CHECK(bits == inked);
  REQUIRE(arcspan_ink_outlines(seen.view, nullptr) == ARCSPAN_OK);
  CHECK(arcspan_draw(seen.view, &target) == ARCSPAN_UNSUPPORTED);
  REQUIRE(arcspan_ink_outlines(seen.view, &ink) == ARCSPAN_OK);
  REQUIRE(arcspan_smooth_outlines(seen.view, nullptr, 0, nullptr) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(seen.view) == ARCSPAN_OK);
  CHECK(arcspan_draw(seen.view, &target) == ARCSPAN_OK);
  CHECK(bits == plain);
  REQUIRE(arcspan_smooth_outlines(seen.view, seen.outline_memory.data(), seen.outline_memory.size(),
                                  &limits) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(seen.view) == ARCSPAN_OK);
  CHECK(arcspan_draw(seen.view, &target) == ARCSPAN_UNSUPPORTED);
}

TEST_CASE("the drawn rectangle holds all that outlines change, also of surfaces beside the picture") {
  Binary ball("curved-ball.bin");
  for (const int width : {-1, 0, 1, 4}) {  // -1: curved instead of inked
    const arcspan_outline_limits limits{2000, 2000, 4000, width < 0 ? 200U : 0U};
    const arcspan_ink ink{{200, 40, 90}, static_cast<std::uint8_t>(width), 1};
    for (std::int32_t i = 0; i < 150; ++i) {
      const std::int32_t x = i % 50 * 8 - 200;  // of the picture's half height: beside it at both ends
      const std::int32_t y = 23 * i;            // edges through the centres of pixels, too
      CAPTURE(width, x, y);
      Scene2 scene({1, 1});
      arcspan_object object = 0;
      REQUIRE(arcspan_add_binary(scene.scene, ball.data(), ball.size, nullptr, &object) == ARCSPAN_OK);
      REQUIRE(arcspan_set_scale(scene.scene, object, ARCSPAN_LENGTH(0.4)) == ARCSPAN_OK);
      REQUIRE(arcspan_set_position(scene.scene, object, {x * 655, y, x * -218}) == ARCSPAN_OK);
      const OutlinedView seen(scene.scene, &limits, width <= 0 ? nullptr : &ink);
      const arcspan_rect drawn = arcspan_drawn_rect(seen.view);
      std::vector<std::uint16_t> whole(kSide * kSide), part(kSide * kSide), depths(kSide * kSide);
      arcspan_target target{whole.data(),         2 * whole.size(), 2 * kSide,     ARCSPAN_RGB565,
                            {0, 0, kSide, kSide}, depths.data(),    depths.size(), nullptr};
      REQUIRE(arcspan_draw(seen.view, &target) == ARCSPAN_OK);
      if (drawn.left < drawn.right) {
        const auto first = static_cast<std::size_t>(drawn.top * kSide + drawn.left);
        target.pixels = part.data() + first;
        target.bytes = 2 * (part.size() - first);
        target.held = drawn;
        REQUIRE(arcspan_draw(seen.view, &target) == ARCSPAN_OK);
      }
      REQUIRE(part == whole);
    }
  }
}

TEST_CASE("parts of the same material share it, and move together") {
  Binary lamp("lamp.bin");
  StoredModel model;
  REQUIRE(ok(view_model_binary({lamp.data(), lamp.size}, model)));
  const auto parts = static_cast<std::uint16_t>(model.part_count());
  REQUIRE(parts > 1);
  // Twice, with materials for one.
  Scene2 two({static_cast<std::uint16_t>(2 * parts), parts});
  arcspan_object first = 99, second = 99;
  REQUIRE(arcspan_add_binary(two.scene, lamp.data(), lamp.size, nullptr, &first) == ARCSPAN_OK);
  REQUIRE(arcspan_add_binary(two.scene, lamp.data(), lamp.size, nullptr, &second) == ARCSPAN_OK);
  CHECK(first == 0);
  CHECK(second == parts);
  Scene2 one({parts, parts});
  REQUIRE(arcspan_add_binary(one.scene, lamp.data(), lamp.size, nullptr, nullptr) == ARCSPAN_OK);
  const auto alone = one.drawn();
  CHECK((two.drawn() == alone));
  REQUIRE(arcspan_set_position(two.scene, second, {0, 0, ARCSPAN_LENGTH(-100)}) == ARCSPAN_OK);
  CHECK((two.drawn() == alone));
  CHECK(arcspan_set_visible(two.scene, first, 0) == ARCSPAN_OK);
  CHECK((two.drawn() == std::vector<std::uint16_t>(kSide * kSide, 0)));
  // A part of an object is no object.
  CHECK(arcspan_set_visible(two.scene, 1, 1) == ARCSPAN_INVALID_ARGUMENT);
}

TEST_CASE("materials of binaries follow the light") {
  Binary ball("ball.bin");
  const arcspan_shares white{32768, 32768, 32768};
  const arcspan_light dim{{-1, 1, 2}, 0, 12000, white};
  const arcspan_light red{{-1, 1, 2}, 0, 32768, {32768, 0, 0}};
  const arcspan_light full{{-1, 1, 2}, 0, 32768, white};
  struct Change {
    const arcspan_light* light;
    arcspan_shares ambient;
  };
  for (const Change& change :
       {Change{&dim, white}, Change{&red, white}, Change{nullptr, white}, Change{&full, {0, 16384, 0}}}) {
    const std::size_t count = change.light != nullptr ? 1 : 0;
    Scene2 before({1, 1});
    REQUIRE(arcspan_set_lights(before.scene, change.light, count, change.ambient) == ARCSPAN_OK);
    REQUIRE(arcspan_add_binary(before.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
    Scene2 after({1, 1});
    REQUIRE(arcspan_add_binary(after.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
    const auto bright = after.drawn();
    REQUIRE(arcspan_set_lights(after.scene, change.light, count, change.ambient) == ARCSPAN_OK);
    CHECK((after.drawn() == before.drawn()));
    CHECK((after.drawn() != bright));
  }
}

TEST_CASE("materials that differ in a number are not shared; a material of a look is used, on both sides") {
  Binary ball("ball.bin");
  const arcspan_material red{{0, 0, 0}, {32768, 0, 0}, {0, 0, 0}, 16};
  const arcspan_look first{ARCSPAN_ARC, 1, 0, &red, 0};
  Scene2 scene({3, 1});
  arcspan_object object = 0;
  const auto add = [&](const arcspan_look& look) {
    return arcspan_add_binary(scene.scene, ball.data(), ball.size, &look, nullptr);
  };
  REQUIRE(arcspan_add_binary(scene.scene, ball.data(), ball.size, &first, &object) == ARCSPAN_OK);
  const auto pixels = scene.drawn();
  CHECK(*std::max_element(pixels.begin(), pixels.end()) >= 0x8000);
  CHECK(add(first) == ARCSPAN_OK);
  for (int i = 0; i < 7; ++i) {
    CAPTURE(i);
    arcspan_material other = red;
    arcspan_look look{ARCSPAN_ARC, 1, 0, &other, 0};
    std::uint16_t* const shares[] = {&other.ambient.g, &other.diffuse.b, &other.specular.r, &other.shininess};
    if (i < 4) *shares[i] = 20;
    if (i == 4) look.method = ARCSPAN_FLAT;
    if (i == 5) look.tolerance = 2;
    if (i == 6) look.two_sided = 1;
    CHECK(add(look) == ARCSPAN_BUFFER_TOO_SMALL);
  }
  for (const bool two_sided : {false, true}) {  // from inside
    const arcspan_look look{ARCSPAN_ARC, 1, two_sided, nullptr, 0};
    Scene2 inside({1, 1});
    REQUIRE(arcspan_add_binary(inside.scene, ball.data(), ball.size, &look, &object) == ARCSPAN_OK);
    REQUIRE(arcspan_set_scale(inside.scene, object, ARCSPAN_LENGTH(5)) == ARCSPAN_OK);
    CHECK((inside.drawn() != std::vector<std::uint16_t>(kSide * kSide, 0)) == two_sided);
  }
}

TEST_CASE("parts of a model are picked as parts of its object, and its box contains all") {
  Binary lamp("lamp.bin");
  StoredModel model;
  REQUIRE(ok(view_model_binary({lamp.data(), lamp.size}, model)));
  Scene2 scene({32, 16});
  arcspan_object first = 99, second = 99;
  REQUIRE(arcspan_add_binary(scene.scene, lamp.data(), lamp.size, nullptr, &first) == ARCSPAN_OK);
  REQUIRE(arcspan_add_binary(scene.scene, lamp.data(), lamp.size, nullptr, &second) == ARCSPAN_OK);
  REQUIRE(arcspan_set_visible(scene.scene, first, 0) == ARCSPAN_OK);
  const OutlinedView seen(scene.scene, nullptr, nullptr);
  std::vector<bool> parts(model.part_count());
  for (std::int32_t i = 0; i < kSide * kSide; ++i) {
    arcspan_picked picked;
    REQUIRE(arcspan_pick(seen.view, i % kSide, i / kSide, &picked) == ARCSPAN_OK);
    if (picked.found == 0) continue;
    REQUIRE(picked.object == second);
    REQUIRE(picked.part < parts.size());
    parts[picked.part] = true;
  }
  CHECK(std::count(parts.begin(), parts.end(), true) > 1);
  arcspan_box box;
  REQUIRE(arcspan_bounds(scene.scene, second, &box) == ARCSPAN_OK);
  std::int32_t low = INT32_MAX, high = INT32_MIN, right = INT32_MIN;
  for (std::size_t i = 0; i < model.part_count(); ++i) {
    const BoundingSphere sphere = model.part(i).sphere;
    low = std::min(low, 2 * (sphere.middle.y - sphere.radius));
    high = std::max(high, 2 * (sphere.middle.y + sphere.radius));
    right = std::max(right, 2 * (sphere.middle.x + sphere.radius));
  }
  CHECK(box.most.x >= right);
  CHECK((box.least.y <= low && box.least.y > low - 8));
  CHECK((box.most.y >= high && box.most.y < high + 8));
}

TEST_CASE("light in steps is that of C++, a material of its own, and follows the light") {
  using Smooth = Arc<c::Light>;
  const arcspan_look toon{ARCSPAN_ARC, 1, 0, nullptr, 3};
  for (const char* const name : {"outlined-lamp.bin", "sign.bin"}) {
    CAPTURE(name);
    Binary binary(name);
    Scene2 scene({16, 16});
    REQUIRE(arcspan_add_binary(scene.scene, binary.data(), binary.size, &toon, nullptr) == ARCSPAN_OK);
    const auto steps = scene.drawn();
    CHECK((steps == drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(binary, false, nullptr, 3)));
    CHECK((steps != drawn_by_cpp<Smooth, Textured<Smooth, Palette8Texels<>>>(binary)));
  }
  Binary lamp("lamp.bin");
  Scene2 stored({16, 16});
  REQUIRE(arcspan_add_binary(stored.scene, lamp.data(), lamp.size, &toon, nullptr) == ARCSPAN_OK);
  Scene2 in_flash({16, 0});
  REQUIRE(arcspan_add_model(in_flash.scene, &stepped, nullptr) == ARCSPAN_OK);
  CHECK((in_flash.drawn() == stored.drawn()));

  Binary ball("ball.bin");
  Scene2 one({2, 1});
  REQUIRE(arcspan_add_binary(one.scene, ball.data(), ball.size, &toon, nullptr) == ARCSPAN_OK);
  CHECK(arcspan_add_binary(one.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_BUFFER_TOO_SMALL);
  const auto bright = one.drawn();
  const arcspan_shares white{32768, 32768, 32768};
  const arcspan_light dim{{-1, 1, 2}, 0, 12000, white};
  REQUIRE(arcspan_set_lights(one.scene, &dim, 1, white) == ARCSPAN_OK);
  const auto dark = one.drawn();
  CHECK(dark != bright);
  Scene2 gradual({1, 1});
  REQUIRE(arcspan_set_lights(gradual.scene, &dim, 1, white) == ARCSPAN_OK);
  REQUIRE(arcspan_add_binary(gradual.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
  CHECK(gradual.drawn() != dark);
}

/// How many materials the parts of a binary have, at least two.
[[nodiscard]] std::uint16_t materials_of(Binary& binary) {
  std::uint16_t count = 1;
  while (true) {
    const Scene2 scene({64, count});
    if (arcspan_add_binary(scene.scene, binary.data(), binary.size, nullptr, nullptr) == ARCSPAN_OK) break;
    ++count;
  }
  REQUIRE(count > 1);
  return count;
}

TEST_CASE("an object is drawn by another material, and by its own again") {
  Binary lamp("lamp.bin");
  const arcspan_shares none{0, 0, 0};
  const arcspan_shares white{32768, 32768, 32768};
  const auto add = [&](const Scene2& scene, const arcspan_material* material, arcspan_object* object) {
    const arcspan_look look{ARCSPAN_ARC, 1, 0, material, 0};
    return arcspan_add_binary(scene.scene, lamp.data(), lamp.size, &look, object);
  };
  const std::uint16_t own = materials_of(lamp);
  const arcspan_material red{{9000, 0, 0}, {20000, 0, 0}, white, 30};
  for (const int more : {0, 1}) {
    Scene2 scene({64, static_cast<std::uint16_t>(own + more)});
    arcspan_object object = 99;
    REQUIRE(add(scene, nullptr, nullptr) == ARCSPAN_OK);
    REQUIRE(add(scene, nullptr, &object) == ARCSPAN_OK);
    REQUIRE(arcspan_set_position(scene.scene, object, {ARCSPAN_LENGTH(0.2), 0, ARCSPAN_LENGTH(0.4)}) ==
            ARCSPAN_OK);
    REQUIRE(arcspan_set_angles(scene.scene, object, 9000, 0, 0) == ARCSPAN_OK);
    const auto before = scene.drawn();
    CHECK(arcspan_set_material(scene.scene, 1, &red) == ARCSPAN_INVALID_ARGUMENT);
    for (const arcspan_material& wrong :
         {arcspan_material{{32769, 0, 0}, none, none, 16}, arcspan_material{none, none, none, 0},
          arcspan_material{none, none, none, 257}}) {
      CHECK(arcspan_set_material(scene.scene, object, &wrong) == ARCSPAN_INVALID_ARGUMENT);
    }
    if (more == 0) {
      CHECK(arcspan_set_material(scene.scene, object, &red) == ARCSPAN_BUFFER_TOO_SMALL);
    } else {
      // Many in the room of one, of which the last is seen, and follows the light.
      for (std::uint16_t shade = 1; shade < 20; ++shade) {
        const arcspan_material grey{none, {shade, shade, shade}, none, 16};
        REQUIRE(arcspan_set_material(scene.scene, object, &grey) == ARCSPAN_OK);
      }
      REQUIRE(arcspan_set_material(scene.scene, object, &red) == ARCSPAN_OK);
      Scene2 expected({64, static_cast<std::uint16_t>(own + 1)});
      REQUIRE(add(expected, nullptr, nullptr) == ARCSPAN_OK);
      REQUIRE(add(expected, &red, &object) == ARCSPAN_OK);
      REQUIRE(arcspan_set_position(expected.scene, object, {ARCSPAN_LENGTH(0.2), 0, ARCSPAN_LENGTH(0.4)}) ==
              ARCSPAN_OK);
      REQUIRE(arcspan_set_angles(expected.scene, object, 9000, 0, 0) == ARCSPAN_OK);
      CHECK((scene.drawn() == expected.drawn()));
      const arcspan_light dim{{-1, 1, 2}, 0, 12000, white};
      const arcspan_light bright{{-1, 1, 2}, 0, 32768, white};
      for (const arcspan_light& light : {dim, bright}) {
        REQUIRE(arcspan_set_lights(scene.scene, &light, 1, white) == ARCSPAN_OK);
        REQUIRE(arcspan_set_lights(expected.scene, &light, 1, white) == ARCSPAN_OK);
        CHECK((scene.drawn() == expected.drawn()));
      }
      CHECK((scene.drawn() != before));
      // There is no room for what another object is drawn by, and there is when this one has its own again.
      const arcspan_material blue{none, {0, 0, 20000}, none, 16};
      CHECK(add(scene, &blue, nullptr) == ARCSPAN_BUFFER_TOO_SMALL);
      CHECK((scene.drawn() == expected.drawn()));
      REQUIRE(arcspan_set_material(scene.scene, object, nullptr) == ARCSPAN_OK);
      CHECK((scene.drawn() == before));
      REQUIRE(add(scene, &blue, &object) == ARCSPAN_OK);
      CHECK(arcspan_set_visible(scene.scene, object, 0) == ARCSPAN_OK);
    }
    CHECK((scene.drawn() == before));
  }
  // A material for each texture, or nothing changes.
  Binary sign("sign.bin");
  const std::uint16_t room = materials_of(sign);
  for (const int more : {1, 2}) {
    Scene2 scene({64, static_cast<std::uint16_t>(room + more)});
    arcspan_object object = 99;
    REQUIRE(arcspan_add_binary(scene.scene, sign.data(), sign.size, nullptr, &object) == ARCSPAN_OK);
    const auto before = scene.drawn();
    CHECK(arcspan_set_material(scene.scene, object, &red) ==
          (more == 2 ? ARCSPAN_OK : ARCSPAN_BUFFER_TOO_SMALL));
    CHECK((scene.drawn() != before) == (more == 2));
  }
  Scene2 in_flash({16, 1});
  arcspan_object flash = 0;
  REQUIRE(arcspan_add_model(in_flash.scene, &outlined, &flash) == ARCSPAN_OK);
  CHECK(arcspan_set_material(in_flash.scene, flash, &red) == ARCSPAN_UNSUPPORTED);
}

TEST_CASE("an object is as translucent as from C++, and opaque again") {
  using Smooth = Arc<c::Light>;
  using SmoothTexture = Textured<Smooth, Palette8Texels<>>;
  for (const char* const name : {"lamp.bin", "sign.bin"}) {
    CAPTURE(name);
    Binary binary(name);
    Scene2 scene({16, 32});
    arcspan_object object = 99;
    REQUIRE(arcspan_add_binary(scene.scene, binary.data(), binary.size, nullptr, &object) == ARCSPAN_OK);
    const auto before = scene.drawn();
    for (const std::uint32_t opacity : {16u, 25u}) {
      REQUIRE(arcspan_set_opacity(scene.scene, object, static_cast<arcspan_share>(opacity << 10)) ==
              ARCSPAN_OK);
      CHECK((scene.drawn() ==
             drawn_by_cpp<WithOperation<Smooth, Opacity<>>, WithOperation<SmoothTexture, Opacity<>>>(
                 binary, false, nullptr, 0, false, Opacity<>{opacity})));
    }
    REQUIRE(arcspan_set_opacity(scene.scene, object, 0) == ARCSPAN_OK);
    CHECK((scene.drawn() == std::vector<std::uint16_t>(kSide * kSide)));
    CHECK(arcspan_set_opacity(scene.scene, object, ARCSPAN_SHARE(1) + 1) == ARCSPAN_INVALID_ARGUMENT);
    CHECK(arcspan_set_opacity(scene.scene, 99, ARCSPAN_SHARE(1)) == ARCSPAN_INVALID_ARGUMENT);
    CHECK((scene.drawn() == std::vector<std::uint16_t>(kSide * kSide)));
    REQUIRE(arcspan_set_opacity(scene.scene, object, ARCSPAN_SHARE(1)) == ARCSPAN_OK);
    CHECK((scene.drawn() == before));
    // Without room for further materials it stays opaque.
    Scene2 full({16, materials_of(binary)});
    REQUIRE(arcspan_add_binary(full.scene, binary.data(), binary.size, nullptr, &object) == ARCSPAN_OK);
    CHECK(arcspan_set_opacity(full.scene, object, ARCSPAN_SHARE(0.5)) == ARCSPAN_BUFFER_TOO_SMALL);
    CHECK(arcspan_set_opacity(full.scene, object, ARCSPAN_SHARE(1)) == ARCSPAN_OK);
    CHECK((full.drawn() == before));
  }
  Scene2 in_flash({16, 1});
  arcspan_object flash = 0;
  REQUIRE(arcspan_add_model(in_flash.scene, &outlined, &flash) == ARCSPAN_OK);
  CHECK(arcspan_set_opacity(in_flash.scene, flash, ARCSPAN_SHARE(0.5)) == ARCSPAN_UNSUPPORTED);
}

TEST_CASE("an object keeps its opacity with another material, and its material with another opacity") {
  Binary lamp("lamp.bin");
  const arcspan_shares white{32768, 32768, 32768};
  const arcspan_material red{{9000, 0, 0}, {20000, 0, 0}, white, 30};
  const std::uint16_t own = materials_of(lamp);
  Scene2 scene({64, static_cast<std::uint16_t>(2 * own)});
  arcspan_object object = 99;
  REQUIRE(arcspan_add_binary(scene.scene, lamp.data(), lamp.size, nullptr, nullptr) == ARCSPAN_OK);
  REQUIRE(arcspan_add_binary(scene.scene, lamp.data(), lamp.size, nullptr, &object) == ARCSPAN_OK);
  REQUIRE(arcspan_set_position(scene.scene, object, {ARCSPAN_LENGTH(0.3), 0, ARCSPAN_LENGTH(0.6)}) ==
          ARCSPAN_OK);
  const auto material = [&](const arcspan_material* set) {
    REQUIRE(arcspan_set_material(scene.scene, object, set) == ARCSPAN_OK);
    return scene.drawn();
  };
  const auto opacity = [&](arcspan_share share) {
    REQUIRE(arcspan_set_opacity(scene.scene, object, share) == ARCSPAN_OK);
    return scene.drawn();
  };
  const auto before = scene.drawn();
  const auto faint = opacity(ARCSPAN_SHARE(0.5));
  const auto faint_red = material(&red);
  const auto all_red = opacity(ARCSPAN_SHARE(1));
  CHECK((faint != before));
  CHECK((faint_red != faint));
  CHECK((all_red != faint_red));
  CHECK((all_red != before));
  CHECK((opacity(ARCSPAN_SHARE(0.5)) == faint_red));
  CHECK((material(nullptr) == faint));
  CHECK((opacity(ARCSPAN_SHARE(1)) == before));
  CHECK((material(&red) == all_red));
  CHECK((opacity(ARCSPAN_SHARE(0.5)) == faint_red));
  // Setting the same material or opacity once more leaves the prepared material as it is, also a wrong byte.
  unsigned char& byte = scene.scene->materials[scene.scene->shown[object]].prepared[100];
  const unsigned char before_change = byte;
  byte = static_cast<unsigned char>(~byte);
  REQUIRE(arcspan_set_material(scene.scene, object, &red) == ARCSPAN_OK);
  REQUIRE(arcspan_set_opacity(scene.scene, object, ARCSPAN_SHARE(0.5)) == ARCSPAN_OK);
  CHECK(byte != before_change);
  byte = before_change;
  // It follows the light.
  const arcspan_light dim{{-1, 1, 2}, 0, 12000, white};
  const arcspan_light bright{{-1, 1, 2}, 0, 32768, white};
  REQUIRE(arcspan_set_lights(scene.scene, &dim, 1, white) == ARCSPAN_OK);
  CHECK((scene.drawn() != faint_red));
  REQUIRE(arcspan_set_lights(scene.scene, &bright, 1, white) == ARCSPAN_OK);
  CHECK((scene.drawn() == faint_red));
  // The other lamp is seen through it.
  CHECK(arcspan_set_visible(scene.scene, 0, 0) == ARCSPAN_OK);
  const auto alone = scene.drawn();
  std::size_t through = 0;
  for (std::size_t i = 0; i < alone.size(); ++i) through += alone[i] != 0 && alone[i] != faint_red[i];
  CHECK(through > 50);
}

TEST_CASE("binaries that cannot be drawn change nothing in a scene") {
  Binary lamp("lamp.bin");
  Binary ball("ball.bin");
  Binary direct("sign-rgb565.bin");
  Scene2 scene({16, 16});
  const auto add = [&](Binary& binary, std::size_t size, const arcspan_look* look) {
    return arcspan_add_binary(scene.scene, binary.data(), size, look, nullptr);
  };
  CHECK(add(lamp, lamp.size - 1, nullptr) == ARCSPAN_TRUNCATED);
  CHECK(add(ball, ball.size - 1, nullptr) == ARCSPAN_TRUNCATED);
  CHECK(add(ball, 0, nullptr) == ARCSPAN_TRUNCATED);
  CHECK(arcspan_add_binary(scene.scene, nullptr, lamp.size, nullptr, nullptr) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_add_binary(scene.scene, lamp.data() + 1, lamp.size - 1, nullptr, nullptr) ==
        ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_add_binary(scene.scene, lamp.data() + 2, lamp.size - 2, nullptr, nullptr) ==
        ARCSPAN_INVALID_ARGUMENT);
  lamp.data()[lamp.size / 2] ^= 1;
  CHECK(add(lamp, lamp.size, nullptr) == ARCSPAN_CORRUPTED);
  lamp.data()[lamp.size / 2] ^= 1;
  const arcspan_look gouraud{ARCSPAN_GOURAUD, 1, 0, nullptr, 0};
  CHECK(add(lamp, lamp.size, &gouraud) == ARCSPAN_UNSUPPORTED);
  CHECK(add(direct, direct.size, nullptr) == ARCSPAN_UNSUPPORTED);
  const arcspan_look tolerance{ARCSPAN_ARC, 65, 0, nullptr, 0};
  CHECK(add(lamp, lamp.size, &tolerance) == ARCSPAN_INVALID_ARGUMENT);
  for (const std::uint8_t steps : {std::uint8_t{1}, std::uint8_t{17}, std::uint8_t{255}}) {
    const arcspan_look toon{ARCSPAN_ARC, 1, 0, nullptr, steps};
    CHECK(add(lamp, lamp.size, &toon) == ARCSPAN_INVALID_ARGUMENT);
  }
  const arcspan_material bright{{40000, 0, 0}, {0, 0, 0}, {0, 0, 0}, 16};
  const arcspan_look too_bright{ARCSPAN_ARC, 1, 0, &bright, 0};
  CHECK(add(lamp, lamp.size, &too_bright) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(arcspan_limits_of(scene.scene, 0).objects == 0);
  Scene2 no_materials({16, 1});
  CHECK(arcspan_add_binary(no_materials.scene, lamp.data(), lamp.size, nullptr, nullptr) ==
        ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(arcspan_add_binary(no_materials.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
  Scene2 no_objects({1, 16});
  CHECK(arcspan_add_binary(no_objects.scene, lamp.data(), lamp.size, nullptr, nullptr) ==
        ARCSPAN_BUFFER_TOO_SMALL);
  CHECK(arcspan_add_binary(no_objects.scene, ball.data(), ball.size, nullptr, nullptr) == ARCSPAN_OK);
}

}  // namespace
