// SPDX-License-Identifier: MIT
// Models are drawn in the colours of their files, by every command that draws.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

enum class Hue { kNone, kGrey, kRed, kGreen, kBlue };

/// The channel that is at least twice as bright as the two others; grey if all are alike.
Hue hue(Rgb8 c) {
  const int most = std::max({c.r, c.g, c.b});
  if (most < 60) return Hue::kNone;
  if (most - std::min({c.r, c.g, c.b}) < 12) return Hue::kGrey;
  if (c.r >= 2 * std::max(c.g, c.b)) return Hue::kRed;
  if (c.g >= 2 * std::max(c.r, c.b)) return Hue::kGreen;
  if (c.b >= 2 * std::max(c.r, c.g)) return Hue::kBlue;
  return Hue::kNone;
}

long count(const Image& picture, Hue wanted) {
  return std::count_if(picture.pixels.begin(), picture.pixels.end(),
                       [wanted](Rgb8 c) { return hue(c) == wanted; });
}

constexpr const char* kColours =
    "newmtl red\nKd 0.9 0.1 0.1\nKs 0 0 0\nnewmtl green\nKd 0.1 0.8 0.1\nKs 0 0 0\n"
    "newmtl blue\nKd 0.1 0.1 0.9\nillum 1\nnewmtl grey\nKd 0.5 0.5 0.5\nKs 0 0 0\n";

/// A smooth ball whose upper, middle and lower thirds have a colour each.
std::string ball() {
  constexpr int kAround = 16;
  constexpr int kBands = 12;
  const double pi = std::acos(-1.0);
  std::string obj = "mtllib colours.mtl\ns 1\n";
  for (int band = 0; band <= kBands; ++band) {
    for (int i = 0; i < kAround; ++i) {
      const double polar = pi * band / kBands;
      const double turn = 2 * pi * i / kAround;
      obj += "v " + std::to_string(std::sin(polar) * std::sin(turn)) + " " + std::to_string(std::cos(polar)) +
             " " + std::to_string(std::sin(polar) * std::cos(turn)) + "\n";
    }
  }
  const char* const materials[] = {"red", "green", "blue"};
  for (int band = 0; band < kBands; ++band) {
    if (band % 4 == 0) obj += std::string("usemtl ") + materials[band / 4] + "\n";
    for (int i = 0; i < kAround; ++i) {
      const int next = (i + 1) % kAround;
      const int corners[] = {band * kAround + i, (band + 1) * kAround + i, (band + 1) * kAround + next,
                             band * kAround + next};
      obj += 'f';
      for (const int corner : corners) obj += " " + std::to_string(corner + 1);
      obj += "\n";
    }
  }
  return obj;
}

/// A box around `centre` as eight vertices and six faces.
std::string box(double x, double y, double z, double width, double height, double depth) {
  std::string obj;
  for (int i = 0; i < 8; ++i) {
    obj += "v " + std::to_string(x + ((i & 1) != 0 ? width : -width)) + " " +
           std::to_string(y + ((i & 2) != 0 ? height : -height)) + " " +
           std::to_string(z + ((i & 4) != 0 ? depth : -depth)) + "\n";
  }
  return obj + "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
}

/// A car of boxes: body, cabin, wheels and bumper.
std::string car() {
  return "mtllib colours.mtl\ns off\no car\ng body\nusemtl red\n" + box(0, 1, 0, 3, 0.6, 1) +
         "g cabin\nusemtl blue\n" + box(0, 2.2, 0, 1.6, 0.6, 0.9) + "g wheels\nusemtl grey\n" +
         box(-2, 0.3, 1, 0.4, 0.4, 0.3) + box(2, 0.3, 1, 0.4, 0.4, 0.3) + "g bumper\nusemtl green\n" +
         box(3.3, 0.8, 0, 0.3, 0.3, 1);
}

/// A cube whose faces have vertices and a colour of their own.
std::string cube() {
  std::string vertices;
  std::string faces;
  const char* const colours[] = {"255 0 0", "0 200 0", "0 0 255"};
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const int first = 4 * (2 * axis + side);
      for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        int at[3];
        at[axis] = side;
        at[(axis + 1) % 3] = u;
        at[(axis + 2) % 3] = v;
        for (const int c : at) vertices += std::to_string(c) + " ";
        vertices += colours[axis] + std::string("\n");
      }
      const int step = side == 1 ? 1 : 3;
      faces += "4";
      for (int i = 0; i < 4; ++i) faces += " " + std::to_string(first + i * step % 4);
      faces += "\n";
    }
  }
  return "ply\nformat ascii 1.0\nelement vertex 24\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 6\n"
         "property list uchar int vertex_indices\nend_header\n" +
         vertices + faces;
}

struct Files {
  TemporaryFolder folder;
  std::string mtl = folder.file("colours.mtl", kColours);

  /// The picture of `render` with these options.
  [[nodiscard]] Image render(const std::string& name, const std::string& text,
                             const std::string& options) const {
    const std::string model = folder.file(name, text);
    const CommandRun done =
        run("render " + model + " -o " + (folder / "p.png") + " --format rgb888 " + options);
    // Of unlit models options of light say that they have no effect.
    CHECK((done.err.empty() ||
           done.err.find("has no effect: the model's materials are unlit") != done.err.npos));
    REQUIRE(done.status == 0);
    return read_image(folder / "p.png");
  }
};

}  // namespace

TEST_CASE("a ball with three colours is drawn in them, one above the other, and stays round") {
  const Files files;
  const std::string front = "--eye 0,0,4 --light 0,0,1 --size 120x120";
  const Image picture = files.render("ball.obj", ball(), front);
  CHECK(hue(picture.at(60, 22)) == Hue::kRed);
  CHECK(hue(picture.at(60, 60)) == Hue::kGreen);
  CHECK(hue(picture.at(60, 98)) == Hue::kBlue);
  // Normals that stop at the borders of colours would make the bands flat there: brightness goes on smoothly.
  const Image plain = files.render("ball.obj", ball(), front + " --colour 1,1,1 --specular 0");
  for (int y = 30; y < 90; ++y) {
    CAPTURE(y);
    CHECK(std::abs(plain.at(60, y).g - plain.at(60, y + 1).g) <= 6);
  }
}

TEST_CASE("a car with four materials is drawn in them; options replace what the file says") {
  const Files files;
  const Image picture = files.render("car.obj", car(), "");
  for (const Hue wanted : {Hue::kRed, Hue::kBlue, Hue::kGreen, Hue::kGrey}) {
    CAPTURE(static_cast<int>(wanted));
    CHECK(count(picture, wanted) > 150);
  }
  const Image repainted = files.render("car.obj", car(), "--colour 0.1,0.9,0.1 --specular 0");
  CHECK(count(repainted, Hue::kGreen) > 8000);
  CHECK(count(repainted, Hue::kRed) + count(repainted, Hue::kBlue) + count(repainted, Hue::kGrey) == 0);
}

TEST_CASE("a cube with vertex colours is drawn in them") {
  const Files files;
  const Image picture = files.render("cube.ply", cube(), "--eye 3,2.5,4 --light 1,1,1");
  for (const Hue wanted : {Hue::kRed, Hue::kGreen, Hue::kBlue}) {
    CAPTURE(static_cast<int>(wanted));
    CHECK(count(picture, wanted) > 1000);
  }
}

TEST_CASE("vertex colours are interpolated, unless another shading is chosen or they are turned off") {
  const Files files;
  const std::string triangle = "v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
  const std::string front = "--eye 0,0,3 --target 0,0,0 --ambient 1 --diffuse 0 --specular 0 --size 120x120 ";
  const auto colours = [&](const std::string& options) {
    const std::string model = files.folder.file("t.obj", triangle);
    REQUIRE(run("render " + model + " -o " + (files.folder / "t.png") + " --format rgb888 --no-smooth " +
                front + options)
                .status == 0);
    const Image picture = read_image(files.folder / "t.png");
    std::set<int> reds;
    for (int x = 0; x < 120; ++x) reds.insert(picture.at(x, 80).r);
    return reds.size();
  };
  CHECK(colours("") > 40);
  CHECK(colours("--shading gouraud") > 40);
  CHECK(colours("--shading arc --vertex-colours") > 40);
  CHECK(colours("--shading arc") == 2);  // the mean and the background
  CHECK(colours("--no-vertex-colours") == 2);
  CHECK(colours("--colour 0,1,0") == 2);
  // At the centre of a pixel the colours are those of its barycentric coordinates.
  const Image picture = files.render("t.obj", triangle, front);
  const double focal = 60 / std::tan(std::acos(-1.0) / 9);
  for (int y = 40; y < 90; y += 7) {
    for (int x = 50; x < 70; x += 3) {
      const double px = (x + 0.5 - 60) * 3 / focal;
      const double py = -(y + 0.5 - 60) * 3 / focal;
      const double blue = (py + 1) / 2;
      const double green = (px + 1 - blue) / 2;
      const Rgb8 c = picture.at(x, y);
      CAPTURE(x, y);
      CHECK(std::abs(c.r - 255 * (1 - blue - green)) <= 2);
      CHECK(std::abs(c.g - 255 * green) <= 2);
      CHECK(std::abs(c.b - 255 * blue) <= 2);
    }
  }
}

TEST_CASE("unlit materials show their colour as it is, emission is added, highlights have their own colour") {
  const Files files;
  const std::string square = "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl m\nf 1 2 3 4\n";
  const auto middle = [&](const std::string& material, const std::string& options = "") {
    (void)files.folder.file("m.mtl", "newmtl m\n" + material);
    const Image picture = files.render("square.obj", square, "--size 32x32 --eye 0,0,4 " + options);
    return picture.at(16, 16);
  };
  const std::string aside = "--light 1,0,0.01";
  CHECK(middle("Kd 0.2 0.4 0.6\nillum 0\n", aside) == Rgb8{51, 102, 153});
  const Rgb8 dark = middle("Kd 0.2 0.4 0.6\nillum 1\n", "--light 0,0,-1");
  CHECK(dark == Rgb8{7, 14, 22});  // 0.14 of the colour, rounded by the pipeline
  CHECK(middle("Kd 0.2 0.4 0.6\nKe 0.5 0 0\nillum 1\n", "--light 0,0,-1").r == 135);
  CHECK(middle("Kd 0.2 0.4 0.6\nKa 0 0 1\nillum 1\n", "--light 0,0,-1") == Rgb8{0, 0, 36});
  const Rgb8 shining = middle("Kd 0 0 0\nKs 0 1 0\nNs 10\n", "--light 0,0,1");
  CHECK(shining == Rgb8{0, 255, 0});
  for (const char* share :
       {" --ambient 0.5", " --diffuse 0.9", " --specular 1", " --ambient 0 --diffuse 1"}) {
    CHECK(middle("Kd 0.2 0.4 0.6\nKa 0 0 1\nillum 0\n", aside + share) == Rgb8{51, 102, 153});
  }
}

TEST_CASE("render makes normals anew by --crease") {
  const Files files;
  const std::string smooth = "mtllib colours.mtl\nusemtl red\ns 1\n" + box(0, 0, 0, 1, 1, 1);
  const auto faces = [&](const std::string& options) {
    const Image picture =
        files.render("box.obj", smooth, "--no-smooth --eye 3,2.5,4 --specular 0 " + options);
    std::set<std::uint8_t> levels;
    for (const Rgb8 c : picture.pixels) levels.insert(c.r);
    return levels.size();
  };
  CHECK(faces("--crease 30") == 4);  // three faces and the background
  CHECK(faces("") > 20);
}

TEST_CASE("turntable and simulate have fog, transparency and environment maps too") {
  const Files files;
  const std::string chrome = files.folder.file("m.ppm", "P6\n1 1\n255\n" + std::string("\x20\x80\xF8", 3));
  const auto drawn = [&](const std::string& options) {
    const CommandRun done = run("simulate sphere:16x8 -o " + (files.folder / "s.png") + " " + options);
    CHECK(done.err.empty());
    REQUIRE(done.status == 0);
    const Image picture = read_image(files.folder / "s.png");
    return picture.at(picture.width / 2, picture.height / 2);
  };
  const Rgb8 plain = drawn("");
  CHECK(hue(plain) != Hue::kBlue);
  const Rgb8 map = drawn("--matcap " + chrome);  // one colour everywhere
  CHECK((std::abs(map.r - 0x20) <= 8 && std::abs(map.g - 0x80) <= 4 && std::abs(map.b - 0xF8) <= 8));
  const Rgb8 fog = drawn("--fog 0.5,1.5#0,0,1");
  CHECK((fog.r < 8 && fog.g < 8 && fog.b > 240));
  const Rgb8 half = drawn("--alpha 0.5 --background 0,0,1");
  CHECK((half.b > 120 && half.r < plain.r));
  const std::string frames = files.folder / "frames";
  REQUIRE(run("turntable sphere:16x8 --frames 2 --size 32x32 --matcap " + chrome + " -o " + frames).status ==
          0);
  for (const auto& entry : std::filesystem::directory_iterator(frames)) {
    CHECK(read_image(entry.path()).at(16, 16).b > 240);
  }
}

TEST_CASE("turntable, simulate and compare draw materials too") {
  const Files files;
  const std::string model = files.folder.file("ball.obj", ball());
  const std::string out = files.folder / "out.png";
  const auto drawn = [&](const std::string& command, const std::string& picture) {
    const CommandRun done = run(command + " " + model + " -o " + out);
    CHECK(done.err.empty());
    REQUIRE(done.status == 0);
    return read_image(picture);
  };
  const auto has_all = [](const Image& picture) {
    return count(picture, Hue::kRed) > 50 && count(picture, Hue::kGreen) > 50 &&
           count(picture, Hue::kBlue) > 50;
  };
  CHECK(has_all(drawn("simulate", out)));
  CHECK(has_all(drawn("compare --no-instructions --shading gouraud --size 96x96", out)));
  std::filesystem::remove(out);
  const CommandRun turned =
      run("turntable " + model + " --frames 2 --size 96x96 --eye 0,0,4 --light 0,0,1 -o " +
          (files.folder / "frames"));
  REQUIRE(turned.status == 0);
  for (const auto& entry : std::filesystem::directory_iterator(files.folder / "frames")) {
    CHECK(has_all(read_image(entry.path())));
  }
}
