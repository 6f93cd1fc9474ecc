// SPDX-License-Identifier: MIT
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/overlay/text.hpp>
#include <arcspan/pixel/mono.hpp>

#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <small_font.hpp>
#include <smooth_font.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <filesystem>
#include <string>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

const std::string kSmall = ARCSPAN_MODELS "/../fonts/small.bdf";
/// A font of two blank glyphs whose compressed data end with its last code.
const std::string kLastBits = ARCSPAN_MODELS "/../fonts/last-bits.pcf.gz";

}  // namespace

TEST_CASE("font: a header that is drawn, the report and the picture") {
  const TemporaryFolder folder;
  const std::string hpp = folder / "my font.hpp";
  const CommandRun made =
      run("font " + kSmall + " -o '" + hpp + "' --range 65-90,0xB0 --report " + (folder / "r.png"));
  CHECK(made.err.empty());
  REQUIRE(made.status == 0);
  CHECK(made.out == hpp +
                        ": 27 characters of 1 bit per pixel, lines of 8 rows, 387 bytes\n"
                        "other characters are shown as U+FFFD\n");
  const std::string header = contents(hpp);
  CHECK(
      header.starts_with("// Made by `arcspan font` from small.bdf.\n// SPDX-License-Identifier: MIT\n//\n"));
  CHECK(header.find("namespace my_font {") != std::string::npos);
  CHECK(header.find("kRanges[] = {\n    {0x41, 0, 26, 1}, {0xB0, 0, 1, 27},\n};") != std::string::npos);
  CHECK(header.find("Font<1> kFont =") != std::string::npos);
  CHECK(read_image(folder / "r.png").width == 4 + 16 * 10);
  CHECK(run("font " + kSmall + " -o hpp:- --name other").out.find("namespace other {") != std::string::npos);
  CHECK(run("font " + kLastBits + " -o hpp:- --range 65-66").status == 0);
  const std::string packed = folder / "small.bdf.gz";
  REQUIRE(std::system(("gzip -c " + kSmall + " >" + packed).c_str()) == 0);
  const std::string plain = run("font " + kSmall + " -o hpp:- --name n").out;
  const std::string unpacked = run("font " + packed + " -o hpp:- --name n").out;
  CHECK(plain.substr(plain.find('\n')) == unpacked.substr(unpacked.find('\n')));
}

TEST_CASE("font: the headers of the build have the letters") {
  std::array<std::uint8_t, 16> memory{};
  hal::Framebuffer<Mono> frame(memory, 16, 8);
  CHECK(overlay::draw_text(frame, small_font::kFont, {0, 0}, "A\u00B0", Rgb8{255, 255, 255}) == Status::kOk);
  std::string rows;
  for (std::int32_t y = 0; y < 8; ++y) {
    for (std::int32_t x = 0; x < 12; ++x) rows += frame.pixel(x, y).r != 0 ? '#' : '.';
    rows += '\n';
  }
  CHECK(rows ==
        ".###...##...\n#...#.#..#..\n#...#.#..#..\n#####..##...\n#...#.......\n#...#.......\n#...#.......\n.."
        "..........\n");
  CHECK(overlay::missing_glyphs(small_font::kFont, "A\u00B0\u00B1") == 1);
  CHECK(smooth_font::kFont.line_height() == 5);
}

TEST_CASE("font: the font that a caption is measured with is the one that the command makes") {
  const CommandRun made = run("font " + kSmall + " --scale 3 --name label_font -o hpp:-");
  CHECK(made.out == contents(ARCSPAN_MODELS "/../../firmware/label_font.inc"));
}

TEST_CASE("font: mistakes are one line, and nothing is written") {
  const TemporaryFolder folder;
  const std::string out = folder / "out.hpp";
  const auto error = [&](const std::string& arguments) { return run("font " + arguments).err; };
  CHECK(error(kSmall + " -o " + out + " --range 9-1") ==
        "arcspan: --range: expected code points or ranges with commas between them, such as 32-126,0xB0, not "
        "'9-1'\n");
  CHECK(error(kSmall + " -o " + out + " --range 1-9") ==
        "arcspan: " + kSmall + ": has none of the characters of --range\n");
  CHECK(error(kSmall + " -o " + out + " --scale 9") ==
        "arcspan: --scale: expected 1...8 or 1/2...1/8, not '9'\n");
  CHECK(error(kSmall + " -o " + out + " --bits 2").find("--bits: expected 1|4") != std::string::npos);
  CHECK(error(kSmall + " -o " + out + " --bits 4") ==
        "arcspan: --bits: 4 needs --scale 1/2 or smaller: the pixels of the file are set or not\n");
  for (const char* wrong : {"out.bin", "out.txt"}) {
    CHECK(error(kSmall + " -o " + (folder / wrong)) ==
          "arcspan: " + (folder / wrong) +
              ": a compiled font is a header: its name must end in .hpp or .h\n");
  }
  CHECK(error(kSmall + " -o " + out + " --name class").find("cannot name a namespace") != std::string::npos);
  const std::string cut = folder.file("cut.bdf", contents(kSmall).substr(0, 2000));
  CHECK(error(cut + " -o " + out).starts_with("arcspan: " + cut + ": line "));
  CHECK(error((folder / "none.bdf") + " -o " + out).starts_with("arcspan: " + (folder / "none.bdf")));
  CHECK(error(cut + " -o " + cut + "/../cut.bdf").find("cut.bdf") != std::string::npos);
  CHECK(folder.size() == 1);  // cut.bdf
  CHECK(run("font " + kSmall + " -o " + out + " --range 65-66,0x4E00-0x4E02").err ==
        "arcspan: warning: " + kSmall + ": has no U+4E00, and 2 more of --range\n");
}

TEST_CASE("font: Debian's fonts are read where they are installed") {
  const std::string terminus = "/usr/share/fonts/X11/misc/ter-u24n_unicode.pcf.gz";
  const std::string unifont = "/usr/share/unifont/unifont.hex";
  if (std::filesystem::exists(terminus)) {
    const CommandRun made = run("font " + terminus + " -o hpp:-");
    CHECK(made.status == 0);
    CHECK(made.err.find("95 characters of 1 bit per pixel, lines of 24 rows") != std::string::npos);
  }
  if (std::filesystem::exists(unifont)) CHECK(run("font " + unifont + " -o hpp:-").status == 0);
}
