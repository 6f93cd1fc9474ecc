// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/comparison.hpp>
#include <arcspan_tools/compare/sheet.hpp>
#include <arcspan_tools/compare/table.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace arcspan::tools;

namespace {

struct Drawn {
  FixedMesh mesh;
  RenderJob job;

  explicit Drawn(const char* name, Scene scene = {}) : mesh(to_fixed(generate(*parse_generated_mesh(name)))) {
    scene.size = {160, 120};
    job = make_job(scene, mesh, name);
  }
  [[nodiscard]] Image by(std::string_view shading) const {
    return find_renderer(shading, "rgb888", false).render(job, [](std::size_t) {}).image;
  }
};

PictureError error_of(const Drawn& drawn, std::string_view shading,
                      ReferenceKind kind = ReferenceKind::kPhong) {
  return picture_error(drawn.by(shading), draw_reference(drawn.job, kind), drawn.job.background);
}

}  // namespace

TEST_CASE("the reference covers what the pipeline covers") {
  Scene green;
  green.background = {0, 1, 0};
  for (const char* name : {"sphere:16x8", "torus:24x12"}) {
    const Drawn drawn(name, green);
    const ReferencePicture reference = draw_reference(drawn.job, ReferenceKind::kSlerp);
    const Image picture = drawn.by("gouraud");
    std::size_t covered = 0;
    for (std::int32_t y = 0; y < reference.height; ++y) {
      for (std::int32_t x = 0; x < reference.width; ++x) {
        const bool background = picture.at(x, y) == drawn.job.background;
        REQUIRE(background == (reference.at(x, y) == nullptr));
        covered += background ? 0u : 1u;
      }
    }
    CHECK(covered > 3000);
  }
}

TEST_CASE("on a finely divided sphere the two references are one, with unit normals") {
  const Drawn drawn("sphere:128x64");
  const ReferencePicture phong = draw_reference(drawn.job, ReferenceKind::kPhong);
  const ReferencePicture slerp = draw_reference(drawn.job, ReferenceKind::kSlerp);
  for (std::int32_t y = 0; y < phong.height; ++y) {
    for (std::int32_t x = 0; x < phong.width; ++x) {
      const ReferenceSample* a = phong.at(x, y);
      const ReferenceSample* b = slerp.at(x, y);
      REQUIRE((a == nullptr) == (b == nullptr));
      if (a == nullptr) continue;
      REQUIRE(std::fabs(length(a->normal) - 1) < 1e-12);
      REQUIRE(length(a->normal - b->normal) < 2e-5);
    }
  }
}

TEST_CASE("the reference's illumination is S0 eq. 12 and eq. 1") {
  ReferenceIllumination light;
  light.ambient = {10, 20, 30};
  light.diffuse = {100, 100, 100};
  light.specular = {50, 50, 50};
  light.shininess = 3;
  light.lights = {{.towards = Vec3{0, 0, 1}}};
  light.to_eye = {0.6, 0, 0.8};
  const Vec3 normal = normalised({0.1, 0.2, 1});
  const double nl = normal.z;
  const double nh = dot(normal, normalised(Vec3{0.6, 0, 1.8}));
  CHECK(light.levels(normal)[0] == Approx(10 + 100 * nl + 50 * std::pow(nh, 3)));
  CHECK(light.levels(normal)[2] == Approx(30 + 100 * nl + 50 * std::pow(nh, 3)));
  light.phong_highlight = true;
  const Vec3 mirrored = normal * (2 * nl) - Vec3{0, 0, 1};
  CHECK(light.levels(normal)[1] == Approx(20 + 100 * nl + 50 * std::pow(dot(mirrored, light.to_eye), 3)));
  CHECK(light.levels({0, 0, -1})[0] == 10);
}

TEST_CASE("the reference has coloured lights and fading highlights") {
  ReferenceIllumination light;
  light.diffuse = {100, 100, 100};
  light.specular = {50, 50, 50};
  light.shininess = 2;
  light.highlight_fade = 0.5;
  light.lights = {{.towards = Vec3{0, 0, 1}, .weights = {1, 0.5, 0}},
                  {.towards = Vec3{1, 0, 0}, .weights = {0, 0.5, 1}}};
  light.to_eye = {0, 0, 1};
  const double nl = 0.8;
  const double low = 0.6;  // of the second light; both are above the fade
  const double shine = std::pow(dot({low, 0, nl}, normalised(Vec3{1, 0, 1})), 2);
  CHECK(light.levels({low, 0, nl})[0] == Approx(100 * nl + 50 * nl * nl));
  CHECK(light.levels({low, 0, nl})[1] == Approx(50 * nl + 25 * nl * nl + 50 * low + 25 * shine));
  CHECK(light.levels({low, 0, nl})[2] == Approx(100 * low + 50 * shine));
  const double faint = std::sqrt(1 - 0.25 * 0.25);
  const double faded = 0.5 * std::pow(dot({0.25, 0, faint}, normalised(Vec3{1, 0, 1})), 2);
  CHECK(light.levels({0.25, 0, faint})[2] == Approx(100 * 0.25 + 50 * faded));
}

TEST_CASE("with coloured lights every method is as near to the reference as with white ones") {
  const auto model = GENERATE(arcspan::Highlight::kBlinn, arcspan::Highlight::kPhong);
  const double fade = GENERATE(0.0, 0.125);
  CAPTURE(model == arcspan::Highlight::kPhong, fade);
  Scene white;
  white.highlight = model;
  white.surface.highlight_fade = fade;
  white.lights = {SceneLight(0.4, 0.7, 0.6), SceneLight(-1, 0.2, 0.3), SceneLight(0.3, -1, 0.5)};
  Scene coloured = white;
  coloured.lights[0].colour = {1, 0.4, 0.1};
  coloured.lights[1].colour = {0.2, 0.3, 1};
  coloured.lights[2].colour = {0, 1, 0.5};
  const Drawn of_white("sphere:32x16", white);
  const Drawn drawn("sphere:32x16", coloured);
  for (const char* shading : {"flat", "gouraud", "arc", "segment", "phong"}) {
    CAPTURE(shading);
    const ReferenceKind kind =
        shading == std::string("segment") ? ReferenceKind::kSlerp : ReferenceKind::kPhong;
    CHECK(error_of(drawn, shading, kind).rms < 1.1 * error_of(of_white, shading, kind).rms);
  }
  CHECK(error_of(drawn, "arc").rms < 0.6);
  CHECK(error_of(drawn, "phong").rms < 0.5);
}

TEST_CASE("errors come in the order that the mathematics says") {
  const Drawn coarse("sphere:12x6");
  const PictureError flat = error_of(coarse, "flat");
  const PictureError gouraud = error_of(coarse, "gouraud");
  const PictureError arc = error_of(coarse, "arc", ReferenceKind::kSlerp);
  CHECK(flat.rms > gouraud.rms);
  CHECK(gouraud.rms > 10 * arc.rms);
  CHECK(arc.rms < 0.6);
  CHECK(flat.ssim < gouraud.ssim);
  CHECK(gouraud.ssim < arc.ssim);
  CHECK(arc.psnr > gouraud.psnr + 20);
}

TEST_CASE("metrics: rounding alone, and a known offset") {
  const Drawn drawn("sphere:16x8");
  const ReferencePicture reference = draw_reference(drawn.job, ReferenceKind::kPhong);
  Image picture = reference.image(drawn.job.background);
  const PictureError rounded = picture_error(picture, reference, drawn.job.background);
  CHECK(rounded.max <= 0.5);
  CHECK(rounded.rms == Approx(1 / std::sqrt(12)).epsilon(0.05));
  CHECK(rounded.ssim > 0.999);
  ReferencePicture exact = reference;
  for (ReferenceSample& sample : exact.samples) sample.levels = {100, 100, 100};
  for (arcspan::Rgb8& p : picture.pixels) p = {103, 103, 103};
  const PictureError off = picture_error(picture, exact, {103, 103, 103});
  CHECK(off.max == 3);
  CHECK(off.rms == Approx(3));
  CHECK(off.psnr == Approx(20 * std::log10(85.0)));
}

TEST_CASE("SSIM of two flat pictures is its luminance term") {
  const Drawn drawn("sphere:16x8");
  ReferencePicture exact = draw_reference(drawn.job, ReferenceKind::kPhong);
  for (ReferenceSample& sample : exact.samples) sample.levels = {100, 100, 100};
  Image picture(exact.width, exact.height);
  for (arcspan::Rgb8& p : picture.pixels) p = {120, 120, 120};
  const double c1 = 2.55 * 2.55;
  CHECK(picture_error(picture, exact, {100, 100, 100}).ssim ==
        Approx((2 * 100 * 120 + c1) / (100 * 100 + 120 * 120 + c1)));
}

TEST_CASE("the colours of errors rise in brightness") {
  CHECK(error_colour(0) == arcspan::Rgb8{0, 0, 0});
  CHECK(error_colour(0.5) == arcspan::Rgb8{0, 0, 0});
  CHECK(error_colour(128) == arcspan::Rgb8{255, 255, 255});
  CHECK(error_colour(255) == arcspan::Rgb8{255, 255, 255});
  for (double steps = 0.5; steps < 100; steps *= 1.5) {
    CHECK(arcspan::luma(error_colour(steps)) < arcspan::luma(error_colour(steps * 1.5)));
  }
}

TEST_CASE("the sheet holds the pictures, the tables hold the figures") {
  const Drawn drawn("sphere:16x8");
  const ReferencePicture reference = draw_reference(drawn.job, ReferenceKind::kPhong);
  Comparison comparison;
  comparison.mesh_name = "sphere:16x8";
  comparison.width = reference.width;
  comparison.height = reference.height;
  comparison.reference = reference.image(drawn.job.background);
  for (const char* name : {"flat", "arc"}) {
    comparison.methods.push_back(measure_method(name, drawn.job, drawn.mesh, reference));
  }
  comparison.yardsticks.push_back({"gouraud", 4, std::nullopt});
  const Image sheet = contact_sheet(comparison, reference);
  const Image& arc = comparison.methods[1].picture;
  bool found = false;
  for (std::int32_t y = 0; y + arc.height <= sheet.height && !found; ++y) {
    for (std::int32_t x = 0; x + arc.width <= sheet.width && !found; ++x) {
      found = true;
      for (std::int32_t row = 0; row < arc.height && found; ++row) {
        for (std::int32_t column = 0; column < arc.width && found; ++column) {
          found = sheet.at(x + column, y + row) == arc.at(column, row);
        }
      }
    }
  }
  CHECK(found);

  const auto json = nlohmann::json::parse(comparison_table(comparison, TableFormat::kJson));
  CHECK(json["methods"].size() == 2);
  CHECK(json["methods"][1]["shading"] == "arc");
  CHECK(json["methods"][1]["rms_error"].get<double>() == comparison.methods[1].error.rms);
  CHECK(json["methods"][1]["instructions"].is_null());
  CHECK(json["methods"][0]["time_per_gouraud"].get<double>() ==
        Approx(comparison.methods[0].nanoseconds / 4));
  const std::string csv = comparison_table(comparison, TableFormat::kCsv);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);
  CHECK(csv.rfind("shading,multiply,shift,add,divide,root,look-up,", 0) == 0);
  CHECK_THROWS_WITH(table_format("x.txt"), "x.txt: a table's name must end in .md, .csv or .json");
  comparison.width = 9000;
  comparison.height = 9000;
  CHECK_THROWS_WITH(contact_sheet(comparison, reference), Catch::StartsWith("--size: the sheet would have"));
}
