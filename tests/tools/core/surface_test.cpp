// SPDX-License-Identifier: MIT
// Textures, vertex colours, transparency, fog and environment maps: the tools choose them at run time, and
// draw the pixels that firmware draws which names them at compile time.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb332.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/environment_map.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/vertex_coloured.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/band_depth.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/texture/plain/made_texture.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using hal::Framebuffer;

namespace {

using Lit = Illumination<1, Highlight::kBlinn>;
constexpr TextureSampler kClamped{TextureWrap::kClamp, TextureWrap::kClamp};

/// 32×16 pixels of many colours and opacities.
RgbaImage picture() {
  RgbaImage image(32, 16);
  for (std::uint32_t i = 0; i < 512; ++i) {
    const std::uint32_t mixed = i * 2654435761u;
    image.pixels[i] = {static_cast<std::uint8_t>(mixed >> 24), static_cast<std::uint8_t>(mixed >> 16),
                       static_cast<std::uint8_t>(mixed >> 8), static_cast<std::uint8_t>(i * 7)};
  }
  return image;
}

/// A sphere with texture points.
Model sphere() {
  return weld_parts(generate_with_texture_points(parse_generated_mesh("sphere:16x8").value()), "sphere",
                    TexturePointsOf::kAllParts);
}

/// The sphere with colours too.
Model coloured_sphere() {
  Model model = sphere();
  MeshData& mesh = model.parts[0].mesh;
  for (const Vec3& p : mesh.positions) mesh.colours.push_back(to_rgb8((p + Vec3{1, 1, 1}) * 0.5));
  return model;
}

Scene small_scene() {
  Scene scene;
  scene.size = {96, 72};
  scene.two_sided = true;  // so that surfaces lie behind each other
  return scene;
}

/// The levels of picture() as a firmware stores them.
template <TexelColour C>
std::vector<std::uint16_t> stored_levels(const RgbaImage& image, const TextureSize& size,
                                         const TextureSampler& sampler = {}) {
  std::vector<std::uint16_t> words;
  for (const RgbaImage& level : mip_levels(image, size, sampler)) {
    for (const Rgba8 c : level.pixels) words.push_back(stored_colour(c, C::kAlphaBits));
  }
  return words;
}

/// Draws the first part of a job as firmware does.
template <class Method, class Format, class Depth = DepthBuffer>
Image firmware(const RenderJob& job, const typename Method::Lighting& lighting) {
  const Viewport& size = job.transform.viewport();
  std::vector<typename Format::Word> memory(Framebuffer<Format>::words(size.width, size.height));
  Framebuffer<Format> frame(memory, size.width, size.height);
  frame.clear(job.background);
  const BandDepth depth(size.width, size.height);
  const RenderPart& part = job.parts.at(0);
  const DrawResult drawn = draw_mesh<Method>(part.mesh, job.transform, lighting, frame, Depth(depth.buffer()),
                                             {}, DrawOptions{part.two_sided});
  REQUIRE(drawn.status == Status::kOk);
  REQUIRE(drawn.triangles > 100);
  Image image(size.width, size.height);
  for (std::int32_t y = 0; y < size.height; ++y) decode_row(frame, y, image.row(y));
  return image;
}

Lit light_of(const RenderJob& job) {
  Lit lit;
  REQUIRE(ok(Lit::make(job.parts.at(0).material, {job.lights.at(0)}, job.to_eye, lit)));
  REQUIRE(ok(lit.set_tolerance(job.tolerance)));
  return lit;
}

Image drawn(const RenderJob& job, const char* shading, const PixelChoice& pixels) {
  return find_renderer(shading, pixels.format, pixels.dithers).render(job, [](std::size_t) {}).image;
}

}  // namespace

TEST_CASE("fog on any shading is that of firmware", "[textures]") {
  Scene scene = small_scene();
  scene.fog = SceneFog{2.2, 3.6, Vec3{0.2, 0.6, 0.9}};
  const FixedModel model = to_fixed(sphere());
  const RenderJob job = make_job(scene, model, "m");
  using Foggy = WithOperation<Arc<Lit>, Fogged>;
  CHECK(drawn(job, "arc", {"rgb565", false}) ==
        firmware<Foggy, Rgb565>(job,
                                Foggy::Lighting(Arc<Lit>::Lighting(light_of(job)), Fogged{job.fog.get()})));
}

TEST_CASE("blended textures in fog are those of firmware", "[textures]") {
  Model model = sphere();
  FileMaterial& material = model.parts[0].look.material;
  material.texture = std::make_shared<FileTexture>(FileTexture{"p", picture()});
  material.alpha_mode = AlphaMode::kBlend;
  Scene scene = small_scene();
  scene.fog = SceneFog{2.2, 3.6, Vec3{0.2, 0.6, 0.9}};
  scene.alpha = 0.8;
  const FixedModel fixed = to_fixed(model);
  const RenderJob job = make_job(scene, fixed, "m");
  using Foggy = WithOperation<Textured<Gouraud<Lit>, DirectTexels<Alpha4Colour>>, Fogged>;
  using Glass = WithOperation<Foggy, Opacity<>>;
  const TextureSize size{5, 4, 5};
  const auto words = stored_levels<Alpha4Colour>(picture(), size);
  Texture<DirectTexels<Alpha4Colour>> texture;
  REQUIRE(ok(Texture<DirectTexels<Alpha4Colour>>::make(words, size, texture)));
  const Foggy::Lighting light(
      Textured<Gouraud<Lit>, DirectTexels<Alpha4Colour>>::Lighting(light_of(job), texture),
      Fogged{job.fog.get()});
  CHECK(drawn(job, "gouraud", {"rgb565", false}) ==
        firmware<Glass, Rgb565, ReadOnlyDepth>(job, Glass::Lighting(light, Opacity<>{26})));
}

TEST_CASE("masked textures behind a screen door are those of firmware, under coloured light", "[textures]") {
  Model model = sphere();
  FileMaterial& material = model.parts[0].look.material;
  material.texture = std::make_shared<FileTexture>(FileTexture{"p", picture()});
  material.alpha_mode = AlphaMode::kMask;
  material.alpha_cutoff = 0.3;
  Scene scene = small_scene();
  scene.transparency = Transparency::kScreenDoor;
  scene.alpha = 0.7;
  scene.lights[0].colour = {1, 0.5, 0.2};
  const FixedModel fixed = to_fixed(model);
  const RenderJob job = make_job(scene, fixed, "m");
  using Surface = Textured<Gouraud<Lit>, DirectTexels<Alpha1Colour>, TexelLight::kColoured>;
  using Screen = WithOperation<Surface, ScreenDoor>;
  const TextureSize size{5, 4, 5};
  const auto words = stored_levels<Alpha1Colour>(picture_of(material), size);
  Texture<DirectTexels<Alpha1Colour>> texture;
  REQUIRE(ok(Texture<DirectTexels<Alpha1Colour>>::make(words, size, texture)));
  const Screen::Lighting light(Surface::Lighting(light_of(job), texture), ScreenDoor{6});
  CHECK(drawn(job, "gouraud", {"gray4", true}) == firmware<Screen, Dithered<Gray4>>(job, light));
  CHECK(job.parts[0].opacity == 6);
}

TEST_CASE("vertex colours that are multiplied with what is behind are those of firmware", "[textures]") {
  Scene scene = small_scene();
  scene.transparency = Transparency::kMultiply;
  scene.alpha = 1;
  scene.background = {0.9, 0.8, 0.7};
  scene.surface.colour = {1, 1, 1};
  const FixedModel model = to_fixed(coloured_sphere());
  const RenderJob job = make_job(scene, model, "m");
  using Glass = WithOperation<VertexColoured<Lit>, Opacity<Blend::kMultiply>>;
  const Glass::Lighting light(light_of(job), Opacity<Blend::kMultiply>{32});
  const std::string shading = GENERATE("arc", "gouraud");
  CHECK(drawn(job, shading.c_str(), {"rgb332", true}) ==
        firmware<Glass, Dithered<Rgb332>, ReadOnlyDepth>(job, light));
}

TEST_CASE("textures times vertex colours are those of firmware", "[textures]") {
  Model model = coloured_sphere();
  model.parts[0].look.material.texture = std::make_shared<FileTexture>(FileTexture{"p", picture()});
  const Scene scene = small_scene();
  const FixedModel fixed = to_fixed(model);
  const RenderJob job = make_job(scene, fixed, "m");
  using Surface = Textured<VertexColoured<Lit>, DirectTexels<>, TexelLight::kColoured>;
  const TextureSize size{5, 4, 5};
  const auto words = stored_levels<OpaqueColour>(picture_of(model.parts[0].look.material), size);
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(words, size, texture)));
  CHECK(drawn(job, "arc", {"rgb565", false}) ==
        firmware<Surface, Rgb565>(job, Surface::Lighting(light_of(job), texture)));
}

TEST_CASE("a stored texture is drawn with the mip levels that its file has", "[textures]") {
  Model model = coloured_sphere();
  FileMaterial& material = model.parts[0].look.material;
  const RgbaImage image = picture();
  const TextureSize all{5, 4, 5};
  const std::size_t kept = GENERATE(std::size_t{0}, std::size_t{1}, std::size_t{4});
  std::vector<RgbaImage> smaller = mip_levels(image, all, {});
  smaller.erase(smaller.begin());
  smaller.resize(kept, RgbaImage(1, 1));
  for (RgbaImage& level : smaller)
    for (Rgba8& c : level.pixels) c.g = static_cast<std::uint8_t>(c.g ^ 0xC0u);  // not those of the picture
  material.texture = std::make_shared<FileTexture>(FileTexture{"p", image, smaller});
  for (Uv& p : model.parts[0].mesh.texture_points) p = {9 * p.u, 9 * p.v};
  const Scene scene = small_scene();
  const FixedModel fixed = to_fixed(model);
  const RenderJob job = make_job(scene, fixed, "m");
  std::vector<std::uint16_t> words;
  smaller.insert(smaller.begin(), image);
  for (const RgbaImage& level : smaller)
    for (const Rgba8& c : level.pixels) words.push_back(static_cast<std::uint16_t>(stored_colour(c, 0)));
  using Surface = Textured<VertexColoured<Lit>, DirectTexels<>, TexelLight::kColoured>;
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(words, {5, 4, static_cast<std::uint8_t>(kept + 1)}, texture)));
  CHECK(drawn(job, "arc", {"rgb565", false}) ==
        firmware<Surface, Rgb565>(job, Surface::Lighting(light_of(job), texture)));
}

/// Checks the pixels of a sphere with a texture that has a sampler, with vertex colours or without.
template <template <class> class Shading, TextureFilter Filter, TextureBorders Borders>
void check_sampler(const char* shading, Model model, TextureWrap u, TextureWrap v) {
  const TextureSampler sampler{u, v, Filter};
  FileMaterial& material = model.parts[0].look.material;
  material.texture = std::make_shared<FileTexture>(FileTexture{"p", picture()});
  material.sampler = sampler;
  for (Uv& p : model.parts[0].mesh.texture_points) p = {3 * p.u - 1, 3 * p.v - 1};
  const Scene scene = small_scene();
  const FixedModel fixed = to_fixed(model);
  const RenderJob job = make_job(scene, fixed, "m");
  using Surface = Textured<Shading<Lit>, DirectTexels<>, texel_light_of<Shading<Lit>>(), Filter, Borders>;
  const TextureSize size{5, 4, 5};
  const auto words = stored_levels<OpaqueColour>(picture_of(material), size, sampler);
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(words, size, texture)));
  const Image image = drawn(job, shading, {"rgb565", false});
  CHECK(image ==
        firmware<Surface, Rgb565>(job, typename Surface::Lighting(light_of(job), texture.with(sampler))));
  if (!sampler.repeats()) {  // borders are in the picture
    CHECK(image != firmware<Surface, Rgb565>(job, typename Surface::Lighting(light_of(job), texture)));
  }
}

TEST_CASE("samplers of textures are those of firmware", "[textures]") {
  constexpr auto kNearest = TextureFilter::kNearest;
  constexpr auto kBilinear = TextureFilter::kBilinear;
  constexpr auto kBorders = TextureBorders::kOfTexture;
  check_sampler<VertexColoured, kBilinear, TextureBorders::kRepeat>(
      "arc", coloured_sphere(), TextureWrap::kRepeat, TextureWrap::kRepeat);
  check_sampler<VertexColoured, kNearest, kBorders>("arc", coloured_sphere(), TextureWrap::kRepeat,
                                                    TextureWrap::kClamp);
  check_sampler<VertexColoured, kBilinear, kBorders>("arc", coloured_sphere(), TextureWrap::kMirror,
                                                     TextureWrap::kClamp);
  check_sampler<Gouraud, kBilinear, kBorders>("gouraud", sphere(), TextureWrap::kClamp, TextureWrap::kMirror);
}

TEST_CASE("an environment map whose light is added is that of firmware", "[textures]") {
  Scene scene = small_scene();
  scene.transparency = Transparency::kAdd;
  scene.alpha = 0.5;
  scene.matcap = surface_texture(picture(), 0, kClamped);
  scene.surface.colour = {1, 1, 1};
  const FixedModel model = to_fixed(coloured_sphere());
  const RenderJob job = make_job(scene, model, "m");
  const TextureSize size{5, 4, 5};
  const auto words = stored_levels<OpaqueColour>(picture(), size, kClamped);
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(words, size, texture)));
  using Map = EnvironmentMap<DirectTexels<>>;
  using Glow = WithOperation<Arc<Map>, Opacity<Blend::kAdd>>;
  const Glow::Lighting light(Map(texture, job.rotation), Opacity<Blend::kAdd>{16});
  CHECK(drawn(job, "arc", {"rgb565", false}) == firmware<Glow, Rgb565, ReadOnlyDepth>(job, light));
}

TEST_CASE("surfaces in bands, and without a depth test, are drawn as they should", "[textures]") {
  Model model = coloured_sphere();
  model.parts.push_back(sphere().parts[0]);
  for (Vec3& p : model.parts[1].mesh.positions) p = p * 0.8 + Vec3{0.7, 0.2, 0.4};
  model.parts[1].look.material.texture = std::make_shared<FileTexture>(FileTexture{"p", picture()});
  model.parts[1].look.material.alpha_mode = AlphaMode::kMask;
  Scene scene = small_scene();
  scene.alpha = GENERATE(0.5, 1.0);
  scene.depth = GENERATE(true, false);
  if (scene.depth) scene.fog = SceneFog{2, 5};
  const FixedModel fixed = to_fixed(model);
  RenderJob job = make_job(scene, fixed, "m");
  const Renderer& renderer = find_renderer("arc", "rgb565", true);
  const RenderResult whole = renderer.render(job, [](std::size_t) {});
  CHECK(whole.stats.depth_bytes == (scene.depth ? 96u * 72 * 2 : 0));
  for (const std::int32_t rows : {1, 7, 71}) {
    job.band_rows = rows;
    const RenderResult banded = renderer.render(job, [](std::size_t) {});
    CHECK(banded.image == whole.image);
    CHECK(banded.stats.triangles == whole.stats.triangles);
    CHECK(banded.stats.pixels == whole.stats.pixels);
  }
}
