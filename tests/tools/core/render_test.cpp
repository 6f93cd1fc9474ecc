// SPDX-License-Identifier: MIT
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;

namespace {

FixedMesh mesh(const char* name) { return to_fixed(generate(parse_generated_mesh(name).value())); }

RenderResult render(const Scene& scene, const FixedMesh& mesh, const char* shading = "arc",
                    const char* format = "rgb888", bool dithers = false) {
  return find_renderer(shading, format, dithers).render(make_job(scene, mesh, "m"), [](std::size_t) {});
}

Scene small_scene() {
  Scene scene;
  scene.size = {96, 72};
  return scene;
}

// How many different colours a picture has.
std::size_t colours(const Image& image) {
  std::set<std::uint32_t> seen;
  for (const Rgb8& p : image.pixels) seen.insert(p.r * 65536u + p.g * 256u + p.b);
  return seen.size();
}

}  // namespace

TEST_CASE("every band height gives the same picture and the same figures") {
  const FixedMesh torus = mesh("torus:24x12");
  const std::string shading = GENERATE(from_range(shading_names()));
  const bool depth = GENERATE(true, false);
  CAPTURE(shading, depth);
  Scene scene = small_scene();
  scene.depth = depth;
  const RenderResult whole = render(scene, torus, shading.c_str(), "rgb565", true);
  CHECK(whole.stats.bands == 1);
  const std::vector<std::int32_t> heights{1, 2, 7, 16, 71, 72, 2048};
  for (const std::int32_t rows : heights) {
    CAPTURE(rows);
    scene.band_rows = rows;
    const RenderResult banded = render(scene, torus, shading.c_str(), "rgb565", true);
    CHECK(banded.image == whole.image);
    CHECK(banded.stats.triangles == whole.stats.triangles);
    CHECK(banded.stats.pixels == whole.stats.pixels);
    CHECK(banded.stats.bands ==
          static_cast<std::uint64_t>((72 + std::min(rows, 72) - 1) / std::min(rows, 72)));
    CHECK(banded.stats.frame_bytes <= whole.stats.frame_bytes);
  }
}

TEST_CASE("every shading and format draws the sphere where it is, over the background") {
  const FixedMesh sphere = mesh("sphere:24x12");
  const std::string shading = GENERATE(from_range(shading_names()));
  const std::string format = GENERATE(from_range(format_names()));
  const bool dithers = GENERATE(false, true);
  CAPTURE(shading, format, dithers);
  Scene scene = small_scene();
  scene.background = {0, 0, 0};
  const RenderResult result = render(scene, sphere, shading.c_str(), format.c_str(), dithers);
  CHECK(result.image.at(0, 0) == Rgb8{});
  CHECK(result.image.at(95, 71) == Rgb8{});
  const auto lit = std::count_if(result.image.pixels.begin(), result.image.pixels.end(),
                                 [](const Rgb8& p) { return p != Rgb8{}; });
  // A disc that fills the height: about pi/4 of 72 x 72 pixels; mono shows only its bright part.
  CHECK(lit > (format == "mono" ? 300 : 3000));
  CHECK(lit < 4100);
  CHECK(result.stats.pixels > 3000);
  CHECK(result.stats.triangles > 100);
}

TEST_CASE("rgb565 drawn directly is the encoding of the picture drawn through virtual calls") {
  const FixedMesh torus = mesh("torus:24x12");
  const std::string shading = GENERATE(from_range(shading_names()));
  const Highlight highlight = GENERATE(Highlight::kBlinn, Highlight::kPhong);
  CAPTURE(shading);
  Scene scene = small_scene();
  scene.highlight = highlight;
  const Image direct = render(scene, torus, shading.c_str(), "rgb565").image;
  Image full = render(scene, torus, shading.c_str(), "rgb888").image;
  for (Rgb8& p : full.pixels) p = Rgb565::decode(Rgb565::encode(p));
  CHECK(direct == full);
}

TEST_CASE("without a depth test, what is drawn last covers what was drawn before") {
  // Two squares: first the nearer one, which faces the light, then a tilted one.
  MeshData squares;
  for (const double tilt : {0.0, 0.4}) {
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      squares.positions.push_back({x, y, tilt > 0 ? -0.5 - tilt * x : 0.5});
      squares.normals.push_back(normalised(Vec3{tilt, 0, 1}));
    }
  }
  squares.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const FixedMesh mesh = to_fixed(squares);
  const std::string shading = GENERATE(from_range(shading_names()));
  CAPTURE(shading);
  Scene scene = small_scene();
  scene.camera.eye = Vec3{0, 0, 4};
  scene.lights = {{0, 0, 1}};
  const Image nearest = render(scene, mesh, shading.c_str()).image;
  scene.depth = false;
  const RenderResult last = render(scene, mesh, shading.c_str());
  CHECK(luma(last.image.at(48, 36)) < luma(nearest.at(48, 36)));
  CHECK(last.stats.depth_bytes == 0);
}

TEST_CASE("the shadings differ as they should") {
  const FixedMesh sphere = mesh("sphere:12x6");
  const Scene scene = small_scene();
  const Image flat = render(scene, sphere, "flat").image;
  const Image gouraud = render(scene, sphere, "gouraud").image;
  const Image arc = render(scene, sphere, "arc").image;
  CHECK(colours(flat) <= 12 * 5 * 2 + 1);
  CHECK(colours(gouraud) > 2 * colours(flat));
  CHECK(gouraud != arc);
  // Gouraud misses a highlight between vertices.
  const auto brightest = [](const Image& image) {
    std::uint8_t level = 0;
    for (const Rgb8& p : image.pixels) level = std::max(level, luma(p));
    return level;
  };
  CHECK(brightest(arc) > brightest(gouraud));
}

TEST_CASE("lights add up, models differ, two-sided fills what culling leaves open") {
  const FixedMesh sphere = mesh("sphere:24x12");
  Scene scene = small_scene();
  const Image one = render(scene, sphere).image;
  std::vector<Image> pictures{one};
  for (const Vec3 light : {Vec3{-1, 0, 0.5}, Vec3{1, -1, 0}, Vec3{0, 0, 1}}) {
    scene.lights.push_back(light);
    pictures.push_back(render(scene, sphere).image);
  }
  for (std::size_t i = 1; i < pictures.size(); ++i) {
    int darker = 0;
    for (std::size_t p = 0; p < one.pixels.size(); ++p) {
      // Several lights are weighted one by one: a step of rounding.
      if (pictures[i].pixels[p].r + 2 < pictures[i - 1].pixels[p].r) ++darker;
    }
    CHECK(darker == 0);
    CHECK(pictures[i] != pictures[i - 1]);
  }
  Scene phong = small_scene();
  phong.highlight = Highlight::kPhong;
  CHECK(render(phong, sphere).image != one);

  // From inside, every face is a back face.
  Scene inside = small_scene();
  inside.camera = {Vec3{0, 0, 0.3}, Vec3{0, 0, -1}, {0, 1, 0}, 60};
  CHECK(render(inside, sphere).stats.pixels == 0);
  inside.two_sided = true;
  CHECK(render(inside, sphere).stats.pixels == 96 * 72);
}

TEST_CASE("a light's strength is 1 / (d + K)") {
  const FixedMesh sphere = mesh("sphere:24x12");
  Scene weaker = small_scene();
  weaker.surface.diffuse = 0.8 / 4;
  weaker.surface.specular = 0.4 / 4;
  Scene farther = small_scene();
  farther.surface.diffuse = 0.8;
  farther.surface.specular = 0.4;
  farther.lights.front().distance = 1.5;
  farther.attenuation = 2.5;
  CHECK(render(farther, sphere).image == render(weaker, sphere).image);
  // Each light has its own distance.
  farther.lights = {SceneLight({0.4, 0.7, 0.6}, 0), SceneLight({-1, 0, 0.2}, 900)};
  Scene alone = farther;
  alone.lights.resize(1, farther.lights.front());
  const Image both = render(farther, sphere).image;
  const Image near = render(alone, sphere).image;
  for (std::size_t p = 0; p < both.pixels.size(); ++p) {
    CHECK(std::abs(int{both.pixels[p].r} - int{near.pixels[p].r}) <= 1);
  }
}

namespace {

/// The picture that firmware draws by arc with the job's tolerance. `Lit` has all lights of the job.
template <class Lit>
Image firmware_picture(const RenderJob& job) {
  using Method = Arc<Lit>;
  const Viewport& size = job.transform.viewport();
  std::vector<std::uint16_t> colours(hal::Framebuffer<Rgb565>::words(size.width, size.height));
  std::vector<std::uint16_t> depths(DepthBuffer::words(size.width, size.height));
  hal::Framebuffer<Rgb565> frame(colours, size.width, size.height);
  DepthBuffer depth(depths, size.width, size.height);
  frame.clear(job.background);
  depth.clear();
  const RenderPart& part = job.parts.front();
  std::array<DirectionalLight, Lit::kLights> lights;
  REQUIRE(job.lights.size() == lights.size());
  std::copy(job.lights.begin(), job.lights.end(), lights.begin());
  Lit lit;
  REQUIRE(ok(Lit::make(part.material, lights, job.to_eye, lit)));
  std::vector<CachedVertex<Method>> cache(part.mesh.vertex_count());
  REQUIRE(ok(lit.set_tolerance(job.tolerance)));
  REQUIRE(ok(draw_mesh<Method>(part.mesh, job.transform, lit, frame, depth, std::span(cache)).status));
  Image image(size.width, size.height);
  for (std::int32_t y = 0; y < size.height; ++y) {
    for (std::int32_t x = 0; x < size.width; ++x) image.at(x, y) = frame.pixel(x, y);
  }
  return image;
}

}  // namespace

TEST_CASE("several lights are drawn as firmware draws them") {
  const FixedMesh torus = mesh("torus:24x12");
  Scene scene = small_scene();
  scene.size = {192, 144};
  scene.lights = {SceneLight(0.4, 0.7, 0.6), SceneLight({-1, 0.2, 0.3}, 0.5)};
  CHECK(render(scene, torus, "arc", "rgb565").image ==
        firmware_picture<Illumination<2, Highlight::kBlinn>>(make_job(scene, torus, "m")));
  scene.highlight = Highlight::kPhong;
  scene.lights[1].colour = {0.25, 0.75, 1};
  CHECK(render(scene, torus, "arc", "rgb565").image ==
        firmware_picture<Illumination<2, Highlight::kPhong, IlluminationFeatures{.coloured_lights = true}>>(
            make_job(scene, torus, "m")));
}

// Coarse spheres have triangles of every order.
TEST_CASE("grey lights are drawn as firmware draws them, from fine and from coarse meshes") {
  const FixedMesh object = mesh(GENERATE("torus:24x12", "sphere:18x9", "sphere:10x6", "sphere:6x4"));
  Scene scene = small_scene();
  scene.size = {192, 144};
  scene.surface.specular = 0.5;
  scene.surface.shininess = GENERATE(8, 32, 100);
  scene.tolerance = GENERATE(0, 1, 8);
  const auto expect_equal = [&](const auto& picture_of) {
    const Image picture = render(scene, object, "arc", "rgb565").image;
    CHECK(picture == picture_of(make_job(scene, object, "m")));
  };
  scene.highlight = Highlight::kPhong;
  scene.lights = {SceneLight(0.4, 0.7, 0.6)};
  expect_equal(firmware_picture<Illumination<1, Highlight::kPhong>>);
  scene.lights.push_back(SceneLight({-1, 0.2, 0.3}, 0.5));
  expect_equal(firmware_picture<Illumination<2, Highlight::kPhong>>);
}

TEST_CASE("by every method, each channel of coloured lights is that of white lights as strong") {
  const FixedMesh sphere = mesh("sphere:12x8");
  const std::string shading = GENERATE(from_range(shading_names()));
  const Highlight model = GENERATE(Highlight::kBlinn, Highlight::kPhong);
  CAPTURE(shading, model == Highlight::kPhong);
  Scene scene = small_scene();
  scene.highlight = model;
  // The third light has no strength. Its colour makes all pictures those of coloured lights: grey ones are
  // summed in a ramp.
  scene.lights = {SceneLight(0.4, 0.7, 0.6), SceneLight(-1, 0.2, 0.3), SceneLight({0, 0, 1}, 1e6)};
  scene.lights[0].colour = {1, 0.5, 0};
  scene.lights[1].colour = {0.25, 0.75, 1};
  scene.lights[2].colour = {1, 0, 0};
  const Image coloured = render(scene, sphere, shading.c_str()).image;
  const auto white = [&](double first, double second) {
    scene.lights[0].colour = {first, first, first};
    scene.lights[1].colour = {second, second, second};
    return render(scene, sphere, shading.c_str()).image;
  };
  const Image red = white(1, 0.25);
  const Image green = white(0.5, 0.75);
  const Image blue = white(0, 1);
  Image expected = red;
  for (std::size_t p = 0; p < expected.pixels.size(); ++p) {
    expected.pixels[p] = {red.pixels[p].r, green.pixels[p].g, blue.pixels[p].b};
  }
  if (model == Highlight::kBlinn && (shading == "arc" || shading == "segment")) {
    // How wide a quadratic surface may be depends on the share that each light has in the highlights.
    const Difference found = difference(coloured, expected);
    CHECK(found.largest <= 1);
    CHECK(found.differing_pixels <= 10);
  } else {
    CHECK(coloured == expected);
  }
  CHECK(coloured != red);
}

TEST_CASE("by every method, the colour of a single light is one with that of the surface") {
  const FixedMesh sphere = mesh("sphere:12x8");
  const std::string shading = GENERATE(from_range(shading_names()));
  CAPTURE(shading);
  Scene lit = small_scene();
  lit.surface.ambient = 0;
  lit.surface.diffuse = 0.75;
  lit.surface.specular = 0.5;
  lit.surface.colour = {1, 1, 1};
  lit.lights = {{0.4, 0.7, 0.6}};
  Scene painted = lit;
  lit.lights[0].colour = {1, 0.5, 0.25};
  painted.surface.colour = {1, 0.5, 0.25};
  painted.surface.specular = Vec3{0.5, 0.25, 0.125};
  CHECK(render(lit, sphere, shading.c_str()).image == render(painted, sphere, shading.c_str()).image);
  // The direct path into rgb565, without dithering, and the one by virtual calls.
  const Image direct = render(lit, sphere, shading.c_str(), "rgb565").image;
  CHECK(direct == render(painted, sphere, shading.c_str(), "rgb565").image);
}

TEST_CASE("by every method, a low highlight fades at the terminator only if that is asked for") {
  const FixedMesh sphere = mesh("sphere:48x32");
  const std::string shading = GENERATE(from_range(shading_names()));
  CAPTURE(shading);
  Scene scene = small_scene();
  scene.surface.ambient = 0.1;
  scene.surface.diffuse = 0;
  scene.surface.specular = 0.8;
  scene.surface.shininess = 2;
  scene.camera.eye = Vec3{0, 0, 4};
  scene.lights = {{1, 0, 0}};
  const Image abrupt = render(scene, sphere, shading.c_str()).image;
  scene.surface.highlight_fade = 0.5;
  const Image fading = render(scene, sphere, shading.c_str()).image;
  // The largest step from pixel to pixel in the middle row, within the sphere.
  const auto largest_step = [](const Image& image) {
    int most = 0;
    for (std::int32_t x = 30; x < 66; ++x) {
      most = std::max(most, std::abs(int{image.at(x, 36).g} - int{image.at(x + 1, 36).g}));
    }
    return most;
  };
  // Gouraud and segments blur the abrupt end, segments of Phong's colours the most.
  CHECK(10 * largest_step(abrupt) > 13 * largest_step(fading));
  for (std::size_t p = 0; p < fading.pixels.size(); ++p) CHECK(fading.pixels[p].g <= abrupt.pixels[p].g + 1);
}

TEST_CASE("shares are per channel") {
  const FixedMesh sphere = mesh("sphere:24x12");
  Scene scene = small_scene();
  scene.surface.ambient = Vec3{0, 0.2, 0};
  scene.surface.diffuse = Vec3{0, 0, 0.5};
  scene.surface.specular = Vec3{0.5, 0, 0};
  for (const Highlight model : {Highlight::kBlinn, Highlight::kPhong}) {
    scene.highlight = model;
    const Image image = render(scene, sphere).image;
    int red = 0;
    int blue = 0;
    for (std::size_t p = 0; p < image.pixels.size(); ++p) {
      if (image.pixels[p] == to_rgb8(scene.background)) continue;
      // Green has the ambient light only, the same everywhere.
      CHECK(image.pixels[p].g == image.pixels[image.pixels.size() / 2 + 48].g);
      red = std::max<int>(red, image.pixels[p].r);
      blue = std::max<int>(blue, image.pixels[p].b);
    }
    CHECK(red > 100);
    CHECK(blue > 20);
  }
}

TEST_CASE("a wrong number of lights or an unknown renderer is refused") {
  const FixedMesh sphere = mesh("sphere:8x4");
  Scene scene = small_scene();
  scene.lights.clear();
  CHECK_THROWS_AS(render(scene, sphere), Failure);
  scene.lights.assign(5, {0, 0, 1});
  CHECK_THROWS_AS(render(scene, sphere), Failure);
  CHECK_THROWS_AS(find_renderer("arc", "rgb1234", false), Failure);
  CHECK(!find_renderer("arc", "rgb888", true).pixels.dithers);
  CHECK(find_renderer("arc", "mono", true).pixels.dithers);
}
