// SPDX-License-Identifier: MIT
// `arcspan simulate` as a user runs it.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

/// `image`, turned clockwise by 90 degrees.
Image turned(const Image& image) {
  Image result(image.height, image.width);
  for (std::int32_t y = 0; y < result.height; ++y) {
    for (std::int32_t x = 0; x < result.width; ++x) result.at(x, y) = image.at(y, image.height - 1 - x);
  }
  return result;
}

}  // namespace

TEST_CASE("what a simulated panel shows is what render draws in its format") {
  const TemporaryFolder folder;
  const struct {
    const char* panel;
    const char* size;
    const char* format;
  } panels[] = {{"ili9341", "240x320", "rgb565"},
                {"st7789", "240x320", "rgb565"},
                {"ssd1351", "128x128", "rgb565"},
                {"ssd0323", "128x64", "gray4"},
                {"ssd1306", "128x64", "mono"}};
  for (const auto& p : panels) {
    const std::string mesh = " torus:24x12 --no-depth -o ";
    REQUIRE(
        run("render --size " + std::string(p.size) + " --format " + p.format + mesh + (folder / "want.png"))
            .status == 0);
    const CommandRun simulated =
        run("simulate --panel " + std::string(p.panel) + mesh + (folder / "got.png"));
    REQUIRE(simulated.status == 0);
    CHECK(read_image(folder / "got.png") == read_image(folder / "want.png"));
    CHECK(simulated.out.find(p.panel) == 0);
    CHECK(simulated.out.find("bottleneck: ") != std::string::npos);
  }
}

TEST_CASE("a glass of another size, a stripe of the memory, turned or inverted, shows what it should") {
  const TemporaryFolder folder;
  const auto drawn = [&](const std::string& size, const std::string& format) {
    REQUIRE(run("render torus:24x12 --no-depth --size " + size + " --format " + format + " -o " +
                (folder / "want.png"))
                .status == 0);
    return read_image(folder / "want.png");
  };
  const auto shown = [&](const std::string& options) {
    const CommandRun r =
        run("simulate torus:24x12 --no-depth --panel " + options + " -o " + (folder / "got.png"));
    CAPTURE(options, r.err);
    REQUIRE(r.status == 0);
    return read_image(folder / "got.png");
  };
  const Image small = drawn("72x40", "mono");
  CHECK(shown("ssd1306-72x40") == small);
  CHECK(shown("ssd1306 --glass 72x40 --glass-at 28,0 --bus i2c") == small);
  CHECK(shown("ssd1306 --glass 72x40 --glass-at 30,12 --no-charge-pump --no-internal-reference") == small);
  CHECK(shown("ssd1306 --glass 70x40 --glass-at 30,12 --spi-mode 3") == drawn("70x40", "mono"));
  CHECK(shown("st7789 --glass 135x240 --glass-at 52,40") == drawn("135x240", "rgb565"));
  CHECK(shown("ssd0323 --glass 96x48 --glass-at 16,12") == drawn("96x48", "gray4"));
  CHECK(shown("ssd0323 --glass 128x80") == drawn("128x80", "gray4"));
  const Image half_turn = turned(turned(small));
  CHECK(shown("ssd1306 --glass 72x40 --glass-at 30,12 --rotate 180") == half_turn);
  CHECK(shown("ssd1306-72x40 --rotation 90") == turned(drawn("40x72", "mono")));
  CHECK(shown("ssd1306 --glass 70x40 --glass-at 30,12 --rotate 90") == turned(drawn("40x70", "mono")));
  Image inverse = small;
  for (arcspan::Rgb8& c : inverse.pixels) c = c.r != 0 ? arcspan::Rgb8{} : arcspan::Rgb8{255, 255, 255};
  CHECK(shown("ssd1306-72x40 --inverted") == inverse);
}

TEST_CASE("a rotated picture lies turned on the glass, and bands make no difference") {
  const TemporaryFolder folder;
  REQUIRE(run("render torus:24x12 --size 320x240 -o " + (folder / "want.png")).status == 0);
  REQUIRE(run("simulate torus:24x12 --rotation 90 --band 40 -o " + (folder / "got.png")).status == 0);
  CHECK(read_image(folder / "got.png") == turned(read_image(folder / "want.png")));
}

TEST_CASE("sending changes only gives the same turn with fewer bytes") {
  const TemporaryFolder folder;
  const std::string turn = "simulate torus:24x12 --panel ssd1306 --bus i2c --turntable 5 -o ";
  const CommandRun whole = run(turn + (folder / "whole.png"));
  const CommandRun changes = run(turn + (folder / "changes.png") + " --changes");
  REQUIRE(whole.status == 0);
  REQUIRE(changes.status == 0);
  CHECK(contents(folder / "whole.png") == contents(folder / "changes.png"));
  const auto bytes = [](const CommandRun& r) { return std::stoi(r.out.substr(r.out.find("sent: ") + 6)); };
  CHECK(bytes(changes) < bytes(whole));
  CHECK(bytes(whole) > 1024);
  // Sending by I2C waits until all is sent.
  CHECK(whole.out.find("both, one after the other: ") != std::string::npos);
}

TEST_CASE(
    "simulate estimates instructions, fewer with planes and more in bands, or says what it has no figures "
    "of") {
  const TemporaryFolder folder;
  const auto instructions = [&folder](const std::string& options) {
    const CommandRun r = run("simulate torus:24x12 " + options + " -o " + (folder / "panel.png"));
    REQUIRE(r.status == 0);
    const std::size_t at = r.out.find("drawing: ");
    REQUIRE(at != std::string::npos);
    return std::atof(r.out.c_str() + at + 9);
  };
  const std::vector<std::string> shadings = {"flat", "gouraud", "segment", "arc"};
  for (const std::string& shading : shadings) {
    CAPTURE(shading);
    const std::string method = "--shading " + shading;
    const double whole = instructions(method + " --band 320");
    CHECK(whole > 100000);
    CHECK(instructions(method + " --band 320 --planes") < whole);
    CHECK(instructions(method + " --band 16") > whole);
  }
  // What it says of other methods is what it says of them alone.
  const std::string by_arc = run("simulate torus:24x12 -o " + (folder / "panel.png")).out;
  CHECK(by_arc.find("both, overlapped: ") != std::string::npos);
  const std::size_t others = by_arc.find("by other methods: flat ");
  REQUIRE(others != std::string::npos);
  CHECK(std::atof(by_arc.c_str() + others + 23) == instructions("--shading flat"));
  const std::size_t gouraud = by_arc.find(", gouraud ", others);
  REQUIRE(gouraud != std::string::npos);
  CHECK(std::atof(by_arc.c_str() + gouraud + 10) == instructions("--shading gouraud"));
  CHECK(by_arc.find("\nadvice: arc, for highlights that move, takes ") != std::string::npos);
  // Outlines are estimated, and the rows of bands that are drawn twice for them.
  const std::size_t outlines = by_arc.find("\noutlines: smoothed by ");
  REQUIRE(outlines != std::string::npos);
  const double of_outlines = std::atof(by_arc.c_str() + outlines + 22);
  CHECK(of_outlines > 10'000);
  CHECK(instructions("") > instructions("--no-smooth") + of_outlines);
  CHECK(instructions("--ink 0,0,0") > instructions(""));
  const auto drawing = [&folder](const std::string& arguments) {
    const std::string out = run("simulate " + arguments + " -o " + (folder / "panel.png")).out;
    const std::size_t at = out.find("drawing: ");
    REQUIRE(at != std::string::npos);
    return out.substr(at, out.find('\n', at) - at);
  };
  const auto without = [&drawing](const std::string& options) { return drawing("torus:24x12 " + options); };
  CHECK(without("--shading phong") == "drawing: no figures of phong shading on a Cortex-M3");
  CHECK(without("--light 1,0,0 --light 0,1,0") == "drawing: no figures of several lights on a Cortex-M3");
  CHECK(without("--fog 1,9") == "drawing: no figures of textures and effects on a Cortex-M3");
  CHECK(without("--shading segment --no-dither")
            .ends_with("; flat faces by segment take up to a quarter more)"));
  CHECK(without("--no-depth").ends_with("; with a depth buffer: without one it takes less)"));
  CHECK(without("--toon 4") == "drawing: no figures of toon light on a Cortex-M3");
  CHECK(without("--no-dither --highlight-fade 0.3").ends_with("; without the fade of highlights)"));
  const std::string walker = std::string(ARCSPAN_EXAMPLES) + "/walker/walker.glb --no-dither";
  CHECK(drawing(walker + " --turntable 2 --clip walk").ends_with("; without posing, see mesh --forecast)"));
  CHECK(drawing(walker + " --turntable 2").ends_with("are kept)"));
  std::ofstream(folder / "sign.obj") << "mtllib sign.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                        "usemtl a\nf 1/1 2/2 3/3\n";
  std::ofstream(folder / "sign.mtl") << "newmtl a\nmap_Kd -clamp on a.ppm\n";
  std::ofstream(folder / "a.ppm") << "P6 2 2 255\n000aaaaaa000";
  CHECK(drawing(folder / "sign.obj" + " --no-dither")
            .ends_with("; for textures that repeat: others take up to 45 instructions more a pixel)"));
  // The estimate is one of pixels in rgb565.
  const std::string other = "; for rgb565 without dither: other pixels take up to 40 instructions more each)";
  CHECK(without("--no-dither").find(other) == std::string::npos);
  CHECK(without("--no-dither --panel ssd1306").ends_with(other));
  CHECK(without("").ends_with(other));
}

TEST_CASE("the bus has the clock of the controller's data sheet, and simulate warns of a higher one") {
  const TemporaryFolder folder;
  const auto simulated = [&folder](const std::string& options) {
    return run("simulate sphere:8x4 " + options + " -o " + (folder / "panel.png"));
  };
  CHECK(simulated("").out.find("SPI at 10 MHz") != std::string::npos);
  CHECK(simulated("--panel ssd1351").out.find("SPI at 4.5 MHz") != std::string::npos);
  CHECK(simulated("--panel st7789 --spi-mhz 15").err.empty());
  CHECK(simulated("--panel st7789 --spi-mhz 40").err ==
        "arcspan: warning: --spi-mhz: 40 is more than the 15 MHz of the data sheet of st7789; many modules "
        "work, none has to\n");
  CHECK(simulated("--panel ssd1306 --bus i2c --i2c-khz 400").err.empty());
  CHECK(simulated("--panel ssd1306 --bus i2c --i2c-khz 1000").err ==
        "arcspan: warning: --i2c-khz: 1000 is more than the 400 kHz of the data sheet of ssd1306; many "
        "modules work, none has to\n");
}

TEST_CASE("simulate warns of curves on a panel that shows no smooth outlines") {
  const TemporaryFolder folder;
  CHECK(run("simulate sphere:6x4 --curved-outlines --panel ssd1306 -o " + (folder / "x.png")).err ==
        "arcspan: warning: --curved-outlines: has no effect: outlines are neither smoothed nor inked\n");
}

TEST_CASE("simulate says in one line what is wrong, and writes nothing") {
  const TemporaryFolder folder;
  const struct {
    const char* arguments;
    const char* line;
  } cases[] = {
      {"--panel ssd1306 --band 12", "arcspan: --band: 12 rows, but ssd1306 needs a multiple of 8\n"},
      {"--bus i2c", "arcspan: --bus: ili9341 is not simulated on I2C\n"},
      {"--spi-mhz 0", "arcspan: --spi-mhz: expected a number 0.01...200, not '0'\n"},
      {"--i2c-khz 100", "arcspan: --i2c-khz: is of --bus i2c\n"},
      {"--panel ssd1306 --bus i2c --spi-mode 3", "arcspan: --spi-mode: is of --bus spi\n"},
      {"--rotate 45", "arcspan: --rotate: expected 0, 90, 180 or 270, not '45'\n"},
      {"--no-charge-pump", "arcspan: --charge-pump: only an ssd1306 has one, not ili9341\n"},
      {"--internal-reference", "arcspan: --internal-reference: only an ssd1306 has one, not ili9341\n"},
      {"--sequential-coms", "arcspan: --alternating-coms: only an ssd1306 has a choice, not ili9341\n"},
      {"--panel ssd1306 --glass 72x40 --glass-at 60,0",
       "arcspan: --glass-at: 72x40 at 60,0 does not fit the 128x64 pixels of ssd1306\n"},
      {"--panel ssd1306 --glass 72x41",
       "arcspan: --glass: 72x41 at 0,0 is not in steps of 1x8, as ssd1306 needs\n"},
      {"--panel ssd1351 --glass-at 0,4 --glass 96x64",
       "arcspan: --glass-at: ssd1351 has its glass at row 0\n"},
      {"--glass-at 4", "arcspan: --glass-at: expected COLUMN,ROW with each 0...1000, not '4'\n"},
      {"--turntable 0", "arcspan: --turntable: expected an integer 1...3600, not '0'\n"}};
  for (const auto& c : cases) {
    const CommandRun r = run("simulate torus:8x8 " + std::string(c.arguments) + " -o " + (folder / "x.png"));
    CHECK(r.status == 2);
    CHECK(r.err == c.line);
  }
  CHECK(run("simulate torus:8x8 -o " + (folder / "x.txt")).status == 1);
  const CommandRun slow = run("simulate torus:8x8 --spi-mhz 0.01 -o " + (folder / "x.png"));
  CHECK(slow.status == 1);
  CHECK(slow.err.starts_with("arcspan: ili9341: timeout: a band takes longer to send than the driver waits"));
  CHECK(folder.size() == 0);
}
