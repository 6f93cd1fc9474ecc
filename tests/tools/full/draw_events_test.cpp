// SPDX-License-Identifier: MIT
// What the estimates of instructions are made of.

#include <arcspan_tools/command/method_advice.hpp>
#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/simulate/forecast.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace arcspan::tools;

namespace {

RenderJob job_of(const FixedModel& model, std::int32_t band_rows) {
  Scene scene;
  scene.size = {120, 90};
  scene.band_rows = band_rows;
  return make_job(scene, model, "model");
}

FixedModel loaded(const std::string& mesh) {
  return to_fixed(
      load_model_file(mesh, TexturePointsOf::kTexturedParts, VertexColours::kMean, kSmoothEverything));
}

/// The events whose name ends with a word, but for "shiny pixel" and "perspective span", which are counted
/// among others, too.
double sum_of(const std::vector<PartEvents>& picture, const std::string& word) {
  double sum = 0;
  for (const PartEvents& part : picture) {
    for (const CostTerm& term : part.terms) {
      if (term.name.ends_with(" " + word) && term.name != "shiny pixel" && term.name != "perspective span")
        sum += term.amount;
    }
  }
  return sum;
}

double amount_of(const std::vector<PartEvents>& picture, const std::string& name) {
  double sum = 0;
  for (const PartEvents& part : picture) {
    for (const CostTerm& term : part.terms) {
      if (term.name == name) sum += term.amount;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("the events of a picture are the spans and pixels that drawing it counts") {
  for (const std::string& mesh : {std::string("torus:24x12"), std::string(ARCSPAN_MODELS) + "/sign.obj"}) {
    const FixedModel model = loaded(mesh);
    for (const std::int32_t band_rows : {90, 16}) {
      const RenderJob job = job_of(model, band_rows);
      for (const char* shading : {"flat", "gouraud", "arc"}) {
        CAPTURE(mesh, band_rows, shading);
        const RenderStats stats =
            find_renderer(shading, "rgb565", false).render(job, [](std::size_t) {}).stats;
        const auto picture = picture_events(shading, job);
        REQUIRE(picture);
        CHECK(sum_of(*picture, "span") == static_cast<double>(stats.spans));
        CHECK(sum_of(*picture, "pixel") == static_cast<double>(stats.pixels));
        CHECK(sum_of(*picture, "written") == static_cast<double>(stats.written));
        CHECK(amount_of(*picture, "vertex") == static_cast<double>(model.vertex_count()));
        // Without batches the rows of each triangle would be compared with each band.
        const double all = band_rows < 90 ? static_cast<double>(model.triangle_count() * stats.bands) : 0;
        const double compared = amount_of(*picture, "row entry");
        CHECK((compared < all) == (amount_of(*picture, "batch") > 0));
        CHECK(compared <= all);
        CHECK((compared > 0) == (all > 0));
        const std::size_t with_rows = band_rows < 90 ? model.triangle_count() : 0;
        CHECK(amount_of(*picture, "row triangle") == static_cast<double>(with_rows));
        const double in_perspective = amount_of(*picture, "perspective span");
        CHECK((in_perspective > 0) == !model.meshes[0].texture_points.empty());
        CHECK(amount_of(*picture, "piece") >= in_perspective);
        CHECK(instructions_on(kSimulatedCore, *picture).value() > static_cast<double>(10 * stats.pixels));
      }
    }
  }
}

TEST_CASE("triangles across a clip plane are events of every band") {
  const FixedModel model = loaded("torus:24x12");
  const auto picture_of = [&model](std::int32_t band_rows) {
    Scene scene;
    scene.size = {120, 90};
    scene.band_rows = band_rows;
    scene.camera.eye = Vec3{0.9, 0.2, 0.3};  // inside the tube
    return picture_events("arc", make_job(scene, model, "torus")).value();
  };
  const auto whole = picture_of(90);
  const double cut = amount_of(whole, "clipped triangle");
  REQUIRE(cut > 10);
  // Clipping leaves up to a corner more for each plane, or nothing.
  CHECK(amount_of(whole, "clip corner") > 2 * cut);
  CHECK(amount_of(whole, "clip corner") < 6 * cut);
  // Six planes, each of which cuts two edges or none.
  CHECK(amount_of(whole, "clip step") > 3 * cut);
  CHECK(amount_of(whole, "clip step") < 6 * 9 * cut);
  CHECK(amount_of(whole, "clip cut") > cut);
  CHECK(std::fmod(amount_of(whole, "clip cut"), 2) == 0);
  CHECK(amount_of(whole, "clip cut") < amount_of(whole, "clip step"));
  CHECK(amount_of(picture_of(16), "clipped triangle") > cut);
  for (const ForecastCore& core : kForecastCores) {
    auto without = whole;
    std::erase_if(without[0].terms, [](const CostTerm& term) { return term.name.starts_with("clip"); });
    CHECK(instructions_on(core.weights, whole).value() >
          instructions_on(core.weights, without).value() + 1000 * cut);
  }
}

TEST_CASE("bilinear texels cost more than the nearest ones") {
  const FixedModel model = loaded(std::string(ARCSPAN_MODELS) + "/sign.obj");
  RenderJob job = job_of(model, 90);
  std::erase_if(job.parts, [](const RenderPart& part) { return part.texture == nullptr; });
  auto texture = std::make_shared<SurfaceTexture>(*job.parts[0].texture);
  texture->view = texture->view.with(
      {arcspan::TextureWrap::kRepeat, arcspan::TextureWrap::kRepeat, arcspan::TextureFilter::kBilinear});
  for (const char* shading : {"flat", "gouraud", "arc"}) {
    CAPTURE(shading);
    const auto nearest = picture_events(shading, job).value();
    CHECK(amount_of(nearest, "bilinear texel") == 0);
    RenderJob filtered = job;
    filtered.parts[0].texture = texture;
    const auto bilinear = picture_events(shading, filtered).value();
    const double texels = amount_of(bilinear, "bilinear texel");
    CHECK(texels == sum_of(bilinear, "written"));
    REQUIRE(texels > 100);
    for (const ForecastCore& core : kForecastCores) {
      const double more =
          instructions_on(core.weights, bilinear).value() - instructions_on(core.weights, nearest).value();
      CHECK(more > 40 * texels);
      CHECK(more < 120 * texels);
    }
  }
}

TEST_CASE("fronts among the triangles that planes leave are events of their own") {
  FixedModel model = loaded("sphere:8x4");
  const auto picture = [&model] {
    Scene scene;
    scene.size = {320, 240};
    scene.camera.view = {0, 0, 1};  // planes tell nothing where the sphere around them is cut
    return picture_events("arc", make_job(scene, model, "sphere")).value();
  };
  const auto plain = picture();
  CHECK(amount_of(plain, "facing front") == 0);
  model.meshes[0] = with_planes(std::move(model.meshes[0]), "sphere");
  const auto planes = picture();
  CHECK(amount_of(planes, "front") == 0);
  CHECK(amount_of(planes, "facing front") == amount_of(plain, "front"));
  REQUIRE(amount_of(planes, "facing front") > 10);
  CHECK(amount_of(planes, "facing triangle") >= amount_of(planes, "facing front"));
}

TEST_CASE("backs that are drawn are events of their own") {
  const FixedModel model = loaded("sphere:8x4");
  RenderJob job = job_of(model, 90);
  const auto front = picture_events("arc", job).value();
  job.parts[0].two_sided = true;
  const auto both = picture_events("arc", job).value();
  CHECK(amount_of(front, "back") == 0);
  const double backs = amount_of(both, "back");
  REQUIRE(backs > 10);
  CHECK(backs == amount_of(both, "triangle in view") - amount_of(front, "triangle in view"));
}

TEST_CASE("pixels of transparent texels are events of their own") {
  const FixedModel model = loaded(std::string(ARCSPAN_MODELS) + "/sign.obj");
  RenderJob job = job_of(model, 90);
  std::erase_if(job.parts, [](const RenderPart& part) { return part.texture == nullptr; });
  const auto opaque = picture_events("arc", job).value();
  CHECK(opaque[0].weights == "textured arc");
  CHECK(amount_of(opaque, "masked texel") == 0);
  // A texel of one part, after which the textures of all have alpha.
  const auto mask = [](std::size_t texels, RenderPart& part) {
    auto texture = std::make_shared<SurfaceTexture>(*part.texture);
    std::fill_n(texture->texels.begin(), texels, 0u);
    REQUIRE(
        ok(arcspan::Texture<SurfaceTexels>::make(texture->texels, part.texture->view.size(), texture->view)));
    part.texture = std::move(texture);
  };
  RenderJob masked = job;
  masked.parts.push_back(job.parts[0]);
  mask(1, masked.parts[1]);
  for (const char* shading : {"flat", "gouraud", "arc"}) {
    const auto picture = picture_events(shading, masked).value();
    CHECK(picture[0].weights == "masked " + std::string(shading));
    for (const ForecastCore& core : kForecastCores)
      CHECK(instructions_on(core.weights, {picture[0]}).value() >
            instructions_on(core.weights, picture_events(shading, job).value()).value());
  }
  mask(job.parts[0].texture->texels.size(), job.parts[0]);
  const auto transparent = picture_events("arc", job).value();
  CHECK(sum_of(transparent, "written") == 0);
  CHECK(amount_of(transparent, "masked texel") ==
        sum_of(transparent, "pixel"));  // none of them hides another
  REQUIRE(amount_of(transparent, "masked texel") > 100);
  for (const ForecastCore& core : kForecastCores)
    CHECK(instructions_on(core.weights, transparent).value() <
          instructions_on(core.weights, {picture_events("arc", masked).value()[0]}).value());
}

TEST_CASE("highlights that are black or coloured are events of their own") {
  const FixedModel model = loaded("sphere:8x4");
  RenderJob job = job_of(model, 90);
  job.tolerance = 0;
  const auto white = picture_events("arc", job).value();
  const double shiny = amount_of(white, "shiny pixel");
  CHECK(shiny > 100);
  CHECK(amount_of(white, "tinted pixel") == 0);
  job.parts[0].material.specular.b = {};
  const auto yellow = picture_events("arc", job).value();
  CHECK(amount_of(yellow, "shiny pixel") == 0);
  CHECK(amount_of(yellow, "tinted pixel") >= shiny);
  for (const ForecastCore& core : kForecastCores)
    CHECK(instructions_on(core.weights, yellow).value() >
          instructions_on(core.weights, white).value() + 8 * shiny);
}

TEST_CASE("the events of outlines are the edges and places that inking and smoothing list") {
  const FixedModel model = with_neighbours(loaded("torus:24x12"), "torus");
  for (const std::int32_t band_rows : {90, 16}) {
    RenderJob job = job_of(model, band_rows);
    const auto drawn = [&job] {
      return find_renderer("flat", "rgb565", false).render(job, [](std::size_t) {});
    };
    const auto amount = [&job](const std::string& name) {
      const auto picture = picture_events("flat", job);
      REQUIRE(picture.value().back().weights == kOutlineWeights);
      CHECK(instructions_on(kSimulatedCore, {picture->back()}).value() > 10'000);
      return amount_of({picture->back()}, name);
    };
    const RenderResult smooth = drawn();
    CHECK(amount("listed edge") == static_cast<double>(smooth.stats.outline_edges));
    CHECK(amount("scanned triangle") == 576);
    CHECK(amount("neighbour byte") == static_cast<double>(model.meshes[0].neighbours.size()) - 576);
    CHECK(amount("differing triangle") <= amount("listed edge"));
    CHECK(amount("triangle") == (band_rows == 90 ? 0 : 576));  // whose rows tell the side
    CHECK(amount("band") == static_cast<double>(smooth.stats.bands));
    CHECK(amount("ink edge") == 0);
    if (band_rows == 90)
      CHECK(10 * amount("entry") + 12 * amount("listed edge") + 576 ==
            static_cast<double>(smooth.stats.outline_bytes));
    job.outlines.smooth = false;
    const RenderResult plain = drawn();
    job.outlines.ink = arcspan::OutlineInk{{255, 0, 0}, 2, false};
    const RenderResult inked = drawn();
    std::size_t whole = 0;
    std::size_t parts = 0;
    for (std::size_t i = 0; i < inked.image.pixels.size(); ++i) {
      if (inked.image.pixels[i] == arcspan::Rgb8{255, 0, 0})
        ++whole;
      else if (!(inked.image.pixels[i] == plain.image.pixels[i]))
        ++parts;
    }
    CHECK(amount("gap") == 0);
    CHECK(amount("ink walk") > 0);
    CHECK(amount("ink row") >= amount("ink walk"));
    CHECK(amount("ink pixel") >= static_cast<double>(whole));
    CHECK(amount("ink entry") >= static_cast<double>(parts));
    CHECK(amount("ink entry") < 1.5 * static_cast<double>(parts));
  }
}

TEST_CASE("there are no events of several lights, fog, transparency, toon, and methods without weights") {
  const FixedModel model = loaded("sphere:8x4");
  const RenderJob plain = job_of(model, 90);
  CHECK(picture_events("arc", plain));
  CHECK_FALSE(picture_events("phong", plain));
  RenderJob job = plain;
  job.lights.push_back(job.lights[0]);
  CHECK_FALSE(picture_events("arc", job));
  job = plain;
  job.parts[0].transparency = Transparency::kAlpha;
  CHECK_FALSE(picture_events("arc", job));
  job = plain;
  job.toon_steps = 4;
  CHECK_FALSE(picture_events("arc", job));
  CHECK(picture_events("gouraud", job));
  CHECK_FALSE(instructions_on("no such core", *picture_events("arc", plain)));
}

TEST_CASE("the advice compares the main methods") {
  CHECK(method_advice({750, 1000, 1210, false}) ==
        "arc, for highlights that move, takes 21 % more than Gouraud; Gouraud for matt surfaces; flat takes "
        "25 % less, for what is far away or has flat faces");
  CHECK(method_advice({1000, 1000, 1001, true}) ==
        "arc takes as much as grey Gouraud: take arc; flat takes as much as grey Gouraud, which is not worth "
        "its facets");
  CHECK(method_advice({950, 1000, 960, true}) ==
        "arc takes 4 % less than grey Gouraud: take arc; flat takes 5 % less, which is not worth its facets");
}
