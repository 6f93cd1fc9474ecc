// SPDX-License-Identifier: MIT
// `arcspan render` as a user runs it.
#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("render writes the picture and the same figures for people and machines") {
  const TemporaryFolder folder;
  const CommandRun drawn =
      run("render sphere:32x16 -o " + (folder / "a.png") + " --stats " + (folder / "a.json"));
  REQUIRE(drawn.status == 0);
  CHECK(drawn.err.empty());
  const Image image = read_image(folder / "a.png");
  CHECK(image.width == 320);
  CHECK(image.height == 240);
  const auto json = nlohmann::json::parse(contents(folder / "a.json"));
  CHECK(json["mesh"]["triangles"] == 960);
  CHECK(json["picture"]["shading"] == "arc");
  CHECK(json["drawn"]["pixels"].get<int>() > 30'000);
  CHECK(json["bytes"]["frame"] == 320 * 240 * 2);
  CHECK(json["bytes"]["depth"] == 320 * 240 * 2);
  const std::string line = "drawn: " + json["drawn"]["triangles"].dump() + " triangles, " +
                           json["drawn"]["spans"].dump() + " spans, " + json["drawn"]["pixels"].dump() +
                           " pixels\n";
  CHECK(drawn.out.find(line) != std::string::npos);
  CHECK(drawn.out.find("pipeline memory: " + json["bytes"]["total"].dump() + " bytes") != std::string::npos);
}

TEST_CASE("PNG, PPM and PGM hold the same picture") {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.ppm", "a.pgm"}) {
    REQUIRE(run("render torus:24x12 --size 80x60 --format gray8 -o " + (folder / name)).status == 0);
  }
  CHECK(read_image(folder / "a.png") == read_image(folder / "a.ppm"));
  CHECK(read_image(folder / "a.png") == read_image(folder / "a.pgm"));
}

TEST_CASE("every option is taken, and has an effect") {
  const TemporaryFolder folder;
  const std::string base = "render torus:16x8 --size 64x48 -o ";
  REQUIRE(run(base + (folder / "a.ppm")).status == 0);
  const std::string plain = contents(folder / "a.ppm");
  for (const char* option : {"--size 48x64",
                             "--format mono",
                             "--no-dither",
                             "--shading flat",
                             "--shading gouraud",
                             "--illumination phong",
                             "--eye 3,2,1",
                             "--target 0,0.2,0",
                             "--up 1,0,0",
                             "--fov 20 --eye 2,2,2",
                             "--light 1,0,0",
                             "--light 0.4,0.7,0.6 --light -1,0,0",
                             "--light 0.4,0.7,0.6@1",
                             "--light 0.4,0.7,0.6#1,0.5,0.5",
                             "--light 0.4,0.7,0.6@0.5#1,0.5,0.5",
                             "--light 0.4,0.7,0.6#1,0,0 --light -1,0,0#0,0,1",
                             "--highlight-fade 1",
                             "--attenuation 2",
                             "--ambient 0,0.3,0.14",
                             "--diffuse 0.7,0.7,0",
                             "--specular 1,0,0",
                             "--shading phong",
                             "--shading kuijk-blake",
                             "--shading reflection-map",
                             "--colour 0,1,0",
                             "--ambient 0.5",
                             "--diffuse 0.1",
                             "--specular 0",
                             "--shininess 5",
                             "--background 1,0,0",
                             "--alpha 0.5",
                             "--alpha 1 --blend add",
                             "--alpha 1 --blend multiply",
                             "--alpha 0.5 --blend screen-door",
                             "--fog 2,4",
                             "--fog 2,4#1,0,0",
                             "--no-depth --eye 3,0.3,0"}) {
    CAPTURE(option);
    const CommandRun drawn = run(base + (folder / "b.ppm") + " " + option);
    CHECK(drawn.err.empty());
    CHECK(drawn.status == 0);
    CHECK(contents(folder / "b.ppm") != plain);
  }
  for (const char* option : {"--alpha 0.5 --blend none",
                             "--blend add",
                             "--vertex-colours",
                             "--no-vertex-colours",
                             "--band 1",
                             "--band 7",
                             "--band 48",
                             "--dither",
                             "--depth",
                             "--two-sided",
                             "--light 0.4,0.7,0.6",
                             "--light 0.4,0.7,0.6@0",
                             "--attenuation 1",
                             "--light 0.4,0.7,0.6#1,1,1",
                             "--light 0.4,0.7,0.6@0#1,1,1",
                             "--highlight-fade 0",
                             "--specular 0.45,0.45,0.45",
                             "--format rgb565",
                             "--fov 40",
                             "--shininess 40"}) {
    CAPTURE(option);
    CHECK(run(base + (folder / "b.ppm") + " " + option).status == 0);
    CHECK(contents(folder / "b.ppm") == plain);
  }
  REQUIRE(run(base + (folder / "a.ppm") + " --shading gouraud").status == 0);
  const CommandRun clear = run(base + (folder / "b.ppm") + " --shading gouraud --fog 50,60");
  CHECK(contents(folder / "b.ppm") == contents(folder / "a.ppm"));
  CHECK(clear.err.find("arcspan: warning: --fog: begins behind the model, which is 2.") == 0);
  // With fog arc draws small triangles by rows.
  REQUIRE(run(base + (folder / "a.ppm") + " --format rgb888").status == 0);
  REQUIRE(run(base + (folder / "b.ppm") + " --format rgb888 --fog 50,60").status == 0);
  CHECK(difference(read_image(folder / "a.ppm"), read_image(folder / "b.ppm")).largest <= 1);
  const CommandRun hidden = run(base + (folder / "b.ppm") + " --fog 0.1,0.2");
  CHECK(hidden.err.find("arcspan: warning: --fog: hides all of the model, which is 2.") == 0);
}

TEST_CASE("dichotomy halves by the polynomial that is asked for, quadratic if none is") {
  const TemporaryFolder folder;
  const std::string base = "render sphere:4x3 --size 64x48 --format rgb888 --shading dichotomy -o ";
  const CommandRun usual = run(base + (folder / "a.ppm"));
  CHECK(usual.out.find("dichotomy-quadratic shading") != std::string::npos);
  REQUIRE(run(base + (folder / "b.ppm") + " --polynomial quadratic").status == 0);
  CHECK(contents(folder / "a.ppm") == contents(folder / "b.ppm"));
  for (const char* other : {"linear", "cubic"}) {
    const CommandRun drawn = run(base + (folder / "b.ppm") + " --polynomial " + other);
    REQUIRE(drawn.status == 0);
    CHECK(drawn.out.find(std::string("dichotomy-") + other + " shading") != std::string::npos);
    CHECK(contents(folder / "a.ppm") != contents(folder / "b.ppm"));
  }
}

TEST_CASE("wrong arguments: one line that names the value, status 2, nothing written") {
  struct Case {
    const char* arguments;
    const char* complaint;
  };
  const Case wrong = GENERATE(values<Case>({
      {"--size 320", "--size: expected WxH with each 1...2048, not '320'"},
      {"--size 0x10", "--size: expected WxH with each 1...2048, not '0x10'"},
      {"--size 99999x99999", "--size: expected WxH with each 1...2048, not '99999x99999'"},
      {"--format rgb666",
       "--format: expected "
       "rgb565|rgb888|gray8|gray4|mono|rgb565_swapped|bgr888|xrgb8888|argb8888|rgb332|gray2, "
       "not 'rgb666'"},
      {"--shading ray",
       "--shading: expected "
       "flat|gouraud|arc|segment|recurrence|recurrence-four|phong|phong-reciprocal|phong-segment|slerp|"
       "kuijk-blake|lyon|duff|reflection-map|arc-vector|dichotomy, not 'ray'"},
      {"--shading adaptive", "--shading: adaptive is now arc with a tolerance: --shading arc --tolerance 1"},
      {"--tolerance 1 --shading gouraud", "--tolerance: only --shading arc has one, not gouraud"},
      {"--tolerance 65", "--tolerance: expected an integer 0...64, not '65'"},
      {"--polynomial fourth",
       "--polynomial: expected linear, quadratic, cubic, root, printed-linear or printed-quadratic, not "
       "'fourth'"},
      {"--segment 5 --shading dichotomy", "--segment: expected an integer 1...4 or adaptive, not '5'"},
      {"--segment 2 --shading phong",
       "--segment: only --shading segment, phong-segment and dichotomy have some, not phong"},
      {"--polynomial cubic", "--polynomial: only --shading dichotomy has one, not arc"},
      {"--polynomial cubic --shading phong", "--polynomial: only --shading dichotomy has one, not phong"},
      {"--illumination lambert", "--illumination: expected blinn or phong, not 'lambert'"},
      {"--eye 1,2", "--eye: expected three numbers X,Y,Z, not '1,2'"},
      {"--eye nan,0,0", "--eye: expected three numbers X,Y,Z, not 'nan,0,0'"},
      {"--up 0,0,0", "--up: expected a direction X,Y,Z, not '0,0,0'"},
      {"--fov 0", "--fov: expected a number 1...170, not '0'"},
      {"--fov 171", "--fov: expected a number 1...170, not '171'"},
      {"--light 0,0,0",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'0,0,0'"},
      {"--light 1,0,0@",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0@'"},
      {"--light 1,0,0@-1",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0@-1'"},
      {"--light 1,0,0@nan",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0@nan'"},
      {"--light 1,0,0#",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0#'"},
      {"--light 1,0,0#1,1",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0#1,1'"},
      {"--light 1,0,0#2,0,0",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0#2,0,0'"},
      {"--light 1,0,0#-1,0,0",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0#-1,0,0'"},
      {"--light 1,0,0#1,1,1@2",
       "--light: expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not "
       "'1,0,0#1,1,1@2'"},
      {"--highlight-fade 1.5", "--highlight-fade: expected a number 0...1, not '1.5'"},
      {"--attenuation 0.5", "--attenuation: expected a number 1...1000, not '0.5'"},
      {"--light 1,0,0 --light 1,0,0 --light 1,0,0 --light 1,0,0 --light 1,0,0",
       "--light: at most 4 lights, not 5"},
      {"--colour 2,0,0", "--colour: expected R,G,B with each 0...1, not '2,0,0'"},
      {"--background red", "--background: expected R,G,B with each 0...1, not 'red'"},
      {"--ambient -0.1", "--ambient: expected a number 0...1 or R,G,B with each 0...1, not '-0.1'"},
      {"--diffuse 1.1", "--diffuse: expected a number 0...1 or R,G,B with each 0...1, not '1.1'"},
      {"--specular much", "--specular: expected a number 0...1 or R,G,B with each 0...1, not 'much'"},
      {"--specular 1,2,0", "--specular: expected a number 0...1 or R,G,B with each 0...1, not '1,2,0'"},
      {"--shininess 0", "--shininess: expected an integer 1...256, not '0'"},
      {"--shininess 257", "--shininess: expected an integer 1...256, not '257'"},
      {"--band 0", "--band: expected an integer 1...2048, not '0'"},
      {"--alpha 1.5", "--alpha: expected a number 0...1, not '1.5'"},
      {"--blend over", "--blend: expected alpha|add|multiply|screen-door|none, not 'over'"},
      {"--fog 2", "--fog: expected NEAR,FAR[#R,G,B] with NEAR below FAR and each of R,G,B 0...1, not '2'"},
      {"--fog 4,2",
       "--fog: expected NEAR,FAR[#R,G,B] with NEAR below FAR and each of R,G,B 0...1, not '4,2'"},
      {"--fog 1,inf",
       "--fog: expected NEAR,FAR[#R,G,B] with NEAR below FAR and each of R,G,B 0...1, not '1,inf'"},
      {"--fog 1,2#2,0,0",
       "--fog: expected NEAR,FAR[#R,G,B] with NEAR below FAR and each of R,G,B 0...1, not '1,2#2,0,0'"},
      {"--fog 1,2 --no-depth", "--fog: needs the depth buffer (not --no-depth)"},
      {"--fog 1,2 --shading phong", "--fog: only --shading flat, gouraud and arc have it, not phong"},
      {"--alpha 0.5 --shading segment", "--alpha: only --shading flat, gouraud and arc have it, not segment"},
      {"--vertex-colours --shading lyon",
       "--vertex-colours: only --shading flat, gouraud and arc have it, not lyon"},
      {"--matcap a.png --shading flat", "--matcap: is drawn by --shading arc, not flat"},
      {"--polish", "--polish: no such option of arcspan render (see arcspan render --help)"},
      {"--eye 0,0,0", "--eye: is where the target is"},
      {"--fog 1,1.0000000001", "--fog: both distances are one for a model of this size"},
      {"--matcap ''", "--matcap: must not be empty"},
      {"--texture ''", "--texture: must not be empty"},
      {"--stats ''", "--stats: must not be empty"},
  }));
  CAPTURE(wrong.arguments);
  const TemporaryFolder folder;
  const CommandRun drawn = run("render sphere:8x4 -o " + (folder / "a.png") + " " + wrong.arguments);
  CHECK(drawn.status == 2);
  CHECK(drawn.err == "arcspan: " + std::string(wrong.complaint) + "\n");
  CHECK(drawn.out.empty());
  CHECK(folder.size() == 0);
}

TEST_CASE("what is wrong with files: one line, status 1, nothing left behind") {
  const TemporaryFolder folder;
  const std::string out = folder / "out.png";
  const auto check = [&](const std::string& arguments, const std::string& complaint) {
    CAPTURE(arguments);
    const CommandRun drawn = run("render " + arguments);
    CHECK(drawn.status == 1);
    CHECK(drawn.err == "arcspan: " + complaint + "\n");
    CHECK(drawn.out.empty());
  };
  const std::string bad = folder.file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n");
  check(bad + " -o " + out, bad + ": line 3: 'x' is not a number");
  check((folder / "none.obj") + " -o " + out, (folder / "none.obj") + ": cannot read (no such file)");
  check("sphere:8x4 -o " + (folder / "out.jpg"),
        (folder / "out.jpg") + ": a picture's name must end in .png, .ppm or .pgm");
  check("sphere:8x4 -o " + (folder / "no/out.png"),
        (folder / "no/out.png") + ": cannot write (there is no folder " + (folder / "no") + ")");
  check("sphere:8x4 -o /proc/out.png", "/proc/out.png: cannot write (No such file or directory)");
  check("sphere:8x4 -o " + out + " --matcap " + bad,
        bad + ": not a PNG, JPEG, BMP, TGA, PPM (P6) or PGM (P5) picture");
  check("sphere:8x4 -o " + bad + " --matcap " + bad,
        bad + ": a picture's name must end in .png, .ppm or .pgm");
  check("sphere:99999x9 -o " + out, "sphere:99999x9: too many vertices (799994; the limit is 65536)");
  CHECK(folder.size() == 1);
}

TEST_CASE("outlines are smoothed where depth and format allow it, in bands as in the whole picture") {
  const TemporaryFolder folder;
  const auto drawn = [&folder](const std::string& options) {
    const CommandRun result = run("render torus:16x8 --size 96x72 -o " + (folder / "a.ppm") + " " + options);
    REQUIRE(result.status == 0);
    const bool says_so = result.out.find("smoothed: ") != std::string::npos;
    CHECK(says_so == (result.out.find(", outlines ") != std::string::npos));
    return std::pair(contents(folder / "a.ppm"), says_so);
  };
  for (const char* format :
       {"rgb565", "rgb888", "gray8", "gray4", "rgb565_swapped", "bgr888", "xrgb8888", "argb8888", "rgb332"}) {
    CAPTURE(format);
    const std::string choice = std::string("--format ") + format;
    const auto smooth = drawn(choice);
    CHECK(smooth.second);
    CHECK(drawn(choice + " --band 11") == smooth);
    CHECK(drawn(choice + " --no-smooth").first != smooth.first);
  }
  for (const char* other : {"--format mono", "--format gray2", "--no-depth"}) {
    const auto plain = drawn(other);
    CHECK_FALSE(plain.second);
    CHECK(drawn(std::string(other) + " --no-smooth") == plain);
  }
  for (const char* blended : {"--alpha 0.5", "--alpha 0.7 --two-sided", "--alpha 0.5 --blend screen-door"}) {
    CAPTURE(blended);
    const auto smooth = drawn(blended);
    CHECK(drawn(std::string(blended) + " --band 11") == smooth);
    CHECK(drawn(std::string(blended) + " --no-smooth").first != smooth.first);
  }
}

TEST_CASE("smoothing that cannot be is refused if it was asked for") {
  const TemporaryFolder folder;
  const auto refused = [&folder](const std::string& options) {
    const CommandRun result = run("render torus:16x8 -o " + (folder / "a.png") + " --smooth " + options);
    CHECK(result.status != 0);
    return result.err;
  };
  CHECK(refused("--no-depth").find("--smooth: needs a depth buffer, not --no-depth") != std::string::npos);
  CHECK(refused("--format mono").find("--smooth: needs at least 4 bits per pixel, not --format mono") !=
        std::string::npos);
}

TEST_CASE("outlines are inked in every format, in bands as in the whole picture") {
  const TemporaryFolder folder;
  const auto drawn = [&folder](const std::string& options) {
    const CommandRun result = run("render torus:16x8 --size 96x72 -o " + (folder / "a.ppm") + " " + options);
    REQUIRE(result.status == 0);
    return std::pair(contents(folder / "a.ppm"), result.out.find("inked") != std::string::npos);
  };
  for (const char* format : {"rgb565", "rgb888", "gray8", "gray4", "rgb565_swapped", "bgr888", "xrgb8888",
                             "argb8888", "rgb332", "gray2", "mono"}) {
    CAPTURE(format);
    const std::string choice = std::string("--format ") + format + " --background 0.8,0.9,1";
    const auto plain = drawn(choice);
    CHECK_FALSE(plain.second);
    const auto inked = drawn(choice + " --ink 0.2,0,0.1");
    CHECK(inked.second);
    CHECK(inked.first != plain.first);
    CHECK(drawn(choice + " --ink 0.2,0,0.1 --band 11") == inked);
    CHECK(drawn(choice + " --ink 0.2,0,0.1:3") != inked);
    CHECK(drawn(choice + " --ink 1,1,0") != inked);
  }
  // With creases.
  const std::string creased = "--crease 5 --no-smooth --ink 0.9,0.1,0.1:2";
  const auto lines = drawn(creased);
  CHECK(drawn(creased + " --band 11") == lines);
  CHECK(drawn(creased + " --no-ink-creases").first != lines.first);
  CHECK(drawn("--ink 0.2,0,0.1:2 --samples 2").second);
}

TEST_CASE("outlines are curved in bands as in the whole picture") {
  const TemporaryFolder folder;
  const auto drawn = [&folder](const std::string& options) {
    const std::string file = folder / "a.ppm";
    REQUIRE(run("render sphere:16x8 --size 96x72 -o " + file + " " + options).status == 0);
    return contents(file);
  };
  const std::string curved = drawn("--curved-outlines");
  CHECK(curved != drawn(""));
  CHECK(curved == drawn("--curved-outlines --band 11"));
  CHECK(curved != drawn("--curved-outlines --no-smooth --ink 0,0,0"));
}

TEST_CASE("light in steps has few colours") {
  const TemporaryFolder folder;
  const auto colours = [&folder](const std::string& options) {
    const std::string file = folder / "a.ppm";
    REQUIRE(run("render sphere:32x16 --size 96x96 --specular 0 --format rgb888 --no-smooth -o " + file + " " +
                options)
                .status == 0);
    const std::string picture = contents(file);
    std::map<std::string, std::size_t> found;
    for (std::size_t i = picture.size() - 96 * 96 * 3; i < picture.size(); i += 3)
      ++found[picture.substr(i, 3)];
    std::size_t many = 0;  // pixels of the four commonest
    std::vector<std::size_t> counts;
    for (const auto& [colour, count] : found) counts.push_back(count);
    std::sort(counts.rbegin(), counts.rend());
    for (std::size_t i = 0; i < std::min<std::size_t>(4, counts.size()); ++i) many += counts[i];
    return many;
  };
  CHECK(colours("--toon 3") > 96 * 96 * 9 / 10);  // background and three steps
  CHECK(colours("") < 96 * 96 * 7 / 10);
}

TEST_CASE("ink and steps that cannot be are refused") {
  const TemporaryFolder folder;
  const auto refused = [&folder](const std::string& options, const std::string& message) {
    CAPTURE(options);
    const CommandRun result = run("render torus:16x8 -o " + (folder / "a.png") + " " + options);
    CHECK(result.status != 0);
    CHECK(result.err.find(message) != std::string::npos);
    CHECK(folder.size() == 0);
  };
  for (const char* ink : {"red", "1,1", "1,1,2", "1,1,1:", "1,1,1:0", "1,1,1:5", "1,1,1:2x", "1,1,1:1.5"}) {
    refused(std::string("--ink ") + ink,
            std::string("--ink: expected R,G,B[:WIDTH] with each of R,G,B 0...1 and "
                        "WIDTH 1...4, not '") +
                ink + "'");
  }
  refused("--ink 0,0,0 --no-depth", "--ink: needs a depth buffer, not --no-depth");
  refused("--no-ink-creases", "--ink-creases: needs --ink");
  refused("--curved-outlines --no-smooth", "--curved-outlines: needs outlines that are smoothed or inked");
  refused("--curved-outlines --alpha 0.5", "--curved-outlines: not of textures, vertex colours");
  refused("--ink 0,0,0:2 --samples 3", "--samples: with ink that is 2 wide at most 2");
  refused("--toon 1", "--toon");
  refused("--toon 17", "--toon");
  refused("--toon 3 --shading flat", "--toon: needs --shading arc, not flat");
  refused("--toon 3 --light 1,0,0#1,0,0 --light 0,1,0", "--toon: several lights must not be coloured");
}

TEST_CASE("several samples a pixel are the mean of a larger picture") {
  const TemporaryFolder folder;
  REQUIRE(run("render torus:16x8 --size 40x30 --samples 3 -o " + (folder / "mean.png")).status == 0);
  REQUIRE(run("render torus:16x8 --size 120x90 -o " + (folder / "large.png")).status == 0);
  const Image mean = read_image(folder / "mean.png");
  const Image large = read_image(folder / "large.png");
  REQUIRE(mean.width == 40);
  REQUIRE(mean.height == 30);
  for (std::int32_t y = 0; y < 30; ++y) {
    for (std::int32_t x = 0; x < 40; ++x) {
      double green = 0;
      for (std::int32_t i = 0; i < 9; ++i) green += large.at(3 * x + i % 3, 3 * y + i / 3).g;
      CHECK(std::abs(green / 9 - mean.at(x, y).g) <= 0.5);
    }
  }
  const CommandRun result = run("render torus:16x8 --size 700x30 --samples 3 -o " + (folder / "a.png"));
  CHECK(result.status != 0);
  CHECK(result.err.find("--samples: 3 times 700x30 is more than 2048x2048") != std::string::npos);
}
