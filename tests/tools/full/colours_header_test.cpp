// SPDX-License-Identifier: MIT
// The header that `arcspan mesh --vertex-colours` writes, in a program; and the binary, drawn.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <colours.hpp>  // made by the build from models/colours.obj
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace arcspan;
using namespace arcspan::test;

TEST_CASE("a header with vertex colours makes a view that has them") {
  MeshView view;
  REQUIRE(ok(colours::make_view(view)));
  REQUIRE(view.vertex_count() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool right = view.position(i).x > 0;
    const bool above = view.position(i).y > 0;
    const Rgb8 wanted =
        right ? (above ? Rgb8{0, 0, 255} : Rgb8{0, 255, 0}) : (above ? Rgb8{255, 255, 255} : Rgb8{255, 0, 0});
    CHECK(view.colour(i) == wanted);
  }
  CHECK(colours::kMaterial.diffuse.g == Coefficient::of(0.78));  // white
}

TEST_CASE("a binary with vertex colours is drawn as its model, in them or in their mean") {
  const TemporaryFolder folder;
  const std::string model = ARCSPAN_MODELS "/colours.obj";
  REQUIRE(run("mesh " + model + " --vertex-colours -o " + (folder / "c.bin")).status == 0);
  const auto drawn = [&](const std::string& name, const std::string& shading) {
    const CommandRun done = run("render " + name + " -o " + (folder / "a.ppm") + shading +
                                " --size 80x60 --eye 0.5,0.5,2 --target 0.5,0.5,0 --format rgb888");
    REQUIRE(done.status == 0);
    return tools::read_image(folder / "a.ppm");
  };
  const tools::Image interpolated = drawn(folder / "c.bin", "");
  CHECK(interpolated != drawn(folder / "c.bin", " --no-vertex-colours"));
  // The material in a binary is its product with the shares of light, so both may differ by rounding.
  const auto largest = [](const tools::Image& a, const tools::Image& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      most =
          std::max({most, std::abs(a.pixels[i].r - b.pixels[i].r), std::abs(a.pixels[i].b - b.pixels[i].b)});
    }
    return most;
  };
  CHECK(largest(interpolated, drawn(model, "")) <= 2);
  CHECK(largest(drawn(folder / "c.bin", " --shading flat"), drawn(model, " --shading flat")) <= 2);
}
