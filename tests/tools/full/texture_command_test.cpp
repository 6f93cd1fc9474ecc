// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <string>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

const std::string kTiles = ARCSPAN_MODELS "/tiles.ppm";

}  // namespace

TEST_CASE("texture: a header, a binary, the error and the picture of both") {
  const TemporaryFolder folder;
  const std::string hpp = folder / "my tiles.hpp";
  const CommandRun made = run("texture " + kTiles + " -o '" + hpp +
                              "' --size 32 --format pal8 --levels all --report " + (folder / "r.png"));
  CHECK(made.err.empty());
  REQUIRE(made.status == 0);
  CHECK(
      made.out.starts_with(kTiles + ": 16x8, resized to 32x32\n" + hpp +
                           ": 32x32 texels, pal8, 6 levels, 1877 bytes\nagainst the picture at that size: "));
  CHECK(made.out.ends_with("exact\n"));  // squares of tiles are copied
  CHECK(run("texture " + kTiles + " -o " + (folder / "smooth.bin") + " --size 32 --filter bilinear")
            .out.find("PSNR") != std::string::npos);
  const std::string header = contents(hpp);
  CHECK(header.find("namespace my_tiles {") != std::string::npos);
  CHECK(header.find("> kTexture =") != std::string::npos);
  const Image picture = read_image(folder / "r.png");
  CHECK(picture.width == 2 * 256 + 8 + 8 + 128);
  CHECK(picture.height == 256);
  CHECK(picture.at(255 + 8 + 8, 8).r > 200);                    // the red tile of the texture
  CHECK(picture.at(2 * (256 + 8) + 4, 4) == picture.at(4, 4));  // the next level
  CHECK(run("texture " + kTiles + " -o bin:- --format gray").out.starts_with("ARCT"));
  CHECK(header.find(".with") == std::string::npos);
  CHECK(run("texture " + kTiles + " -o bin:- --wrap clamp,mirror --filter bilinear").out.at(15) ==
        (1 | 2 << 2 | 1 << 4));
  CHECK(run("texture " + kTiles + " -o hpp:- --filter bilinear --wrap mirror")
            .out.find("        .with({arcspan::TextureWrap::kMirror, arcspan::TextureWrap::kMirror,\n"
                      "               arcspan::TextureFilter::kBilinear});\n") != std::string::npos);
  CHECK(run("texture " + kTiles + " -o " + (folder / "t.bin")).out.find("against the picture: exact") !=
        std::string::npos);
}

TEST_CASE("texture: mistakes are one line, and nothing is written") {
  const TemporaryFolder folder;
  const std::string out = folder / "out.hpp";
  const auto error = [&](const std::string& arguments) { return run("texture " + arguments).err; };
  CHECK(error(kTiles + " -o " + out + " --size 100") ==
        "arcspan: --size: expected powers of two from 8 to 1024, such as 128 or 128x64, not '100'\n");
  CHECK(error(kTiles + " -o " + out + " --size big") ==
        "arcspan: --size: expected powers of two from 8 to 1024, such as 128 or 128x64, not 'big'\n");
  CHECK(error(kTiles + " -o " + out + " --levels 0") ==
        "arcspan: --levels: expected an integer 1...11 or 'all', not '0'\n");
  for (const char* wrong : {"clamp,", "clamp,clamp,clamp", "border"}) {
    CHECK(error(kTiles + " -o " + out + " --wrap " + wrong) ==
          std::string("arcspan: --wrap: expected repeat|clamp|mirror, or two of them with a comma, not '") +
              wrong + "'\n");
  }
  CHECK(error(kTiles + " -o " + out + " --filter linear") ==
        "arcspan: --filter: expected nearest|bilinear, not 'linear'\n");
  CHECK(error(kTiles + " -o " + out + " --format dxt1").find("--format: expected rgb565|rgba5551|") !=
        std::string::npos);
  CHECK(error(kTiles + " -o " + (folder / "out.png")) ==
        "arcspan: " + (folder / "out.png") + ": a compiled texture's name must end in .hpp, .h or .bin\n");
  const std::string cut = folder.file("cut.ppm", contents(kTiles).substr(0, 100));
  CHECK(error(cut + " -o " + out).starts_with("arcspan: " + cut + ": "));
  CHECK(error(kTiles + " -o " + out + " --report " + (folder / "no/r.png")).find("no") != std::string::npos);
  CHECK(error((folder / "none.png") + " -o " + out).starts_with("arcspan: " + (folder / "none.png")));
  CHECK(folder.size() == 1);  // cut.ppm
}
