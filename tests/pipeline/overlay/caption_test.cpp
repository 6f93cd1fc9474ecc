// SPDX-License-Identifier: MIT
#include <arcspan/overlay/caption.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/overlay/overlay_support.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::overlay;
using namespace arcspan::test;

namespace {

constexpr Rgb8 kInk = TextPicture::kInk;

/// A font whose letters are 1 pixel in 2 columns, and whose spaces are 2 columns: lines are easy to count.
const Font<1>& dots() {
  static const DrawnFont<1> font({{0xFFFD, 0, 0, 2, {"#"}}, {' ', 0, 0, 2, {}}, {'a', 0, 0, 2, {"#"}}}, 2);
  return font.font;
}

/// The lines of a caption in `columns` letters, as the picture shows them.
Rows lines(Utf8Text text, std::int32_t columns, HorizontalAlignment alignment = HorizontalAlignment::kLeft) {
  TextPicture picture(20, 20);
  CHECK(draw_caption(picture.frame, dots(), {0, 0, 2 * columns, 20}, text, kInk, alignment) == Status::kOk);
  Rows found;
  const Rows rows = picture.rows();
  for (std::size_t y = 0; y < rows.size(); y += 2) {
    std::string line;
    for (std::size_t x = 0; x < 20; x += 2) line += rows[y][x] == '#' ? 'a' : ' ';
    line.erase(line.find_last_not_of(' ') + 1);
    found.push_back(line);
  }
  while (!found.empty() && found.back().empty()) found.pop_back();
  return found;
}

}  // namespace

TEST_CASE("captions: lines end at spaces and newlines, and long words are broken") {
  CHECK(lines("aa aa aa", 5) == Rows{"aa aa", "aa"});
  CHECK(lines("aa aa aa", 8) == Rows{"aa aa aa"});
  CHECK(lines("aa aa aa", 7) == Rows{"aa aa", "aa"});
  CHECK(lines("aa   aa", 4) == Rows{"aa", "aa"});
  CHECK(lines("aa\naa", 9) == Rows{"aa", "aa"});
  CHECK(lines("aa\r\n\r\naa\n", 9) == Rows{"aa", "", "aa"});
  CHECK(lines("aaaaaaa", 3) == Rows{"aaa", "aaa", "a"});
  CHECK(lines("a aaaaa", 3) == Rows{"a", "aaa", "aa"});
  CHECK(lines("  aa a", 5) == Rows{"  aa", "a"});
  CHECK(lines("   aaa", 4) == Rows{"   a", "aa"});
  CHECK(lines("   aaa", 2) == Rows{"", "aa", "a"});
  CHECK(lines("aa ", 2) == Rows{"aa"});
  CHECK(lines("aa \na", 2) == Rows{"aa", "a"});
  CHECK(lines("aa\xC3\xA4\xFF", 3) == Rows{"aaa", "a"});
  CHECK(lines("", 3).empty());
  CHECK(lines("   ", 2).empty());
}

TEST_CASE("captions: lines are aligned in their rectangle") {
  CHECK(lines("aa aaa", 5, HorizontalAlignment::kRight) == Rows{"   aa", "  aaa"});
  CHECK(lines("a aaa", 3, HorizontalAlignment::kCentre) == Rows{" a", "aaa"});
  const auto rows_of = [](VerticalAlignment vertical, Utf8Text text) {
    TextPicture picture(9, 9);
    CHECK(draw_caption(picture.frame, dots(), {1, 1, 7, 8}, text, kInk,
                       Alignment{HorizontalAlignment::kRight, vertical}) == Status::kOk);
    std::string rows;
    for (const std::string& row : picture.rows()) rows += row.find('#') == std::string::npos ? ' ' : '#';
    return rows;
  };
  CHECK(rows_of(VerticalAlignment::kTop, "a a\na") == " # #     ");
  CHECK(rows_of(VerticalAlignment::kMiddle, "a a\na") == "  # #    ");
  CHECK(rows_of(VerticalAlignment::kBottom, "a a\na") == "    # #  ");
  CHECK(rows_of(VerticalAlignment::kBottom, "a\na\na\na\na") == " # # # # ");  // the fifth does not fit
  CHECK(rows_of(VerticalAlignment::kMiddle, "") == "         ");
}

TEST_CASE("captions: nothing is drawn outside of the rectangle") {
  TextPicture picture(20, 10);
  CHECK(draw_caption(picture.frame, plain_font().font, {3, 2, 9, 7}, "Lip\npLi",
                     OutlinedText{kInk, TextPicture::kOther}) == Status::kOk);
  const Rows rows = picture.rows();
  std::size_t drawn = 0;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      const bool inside = x >= 3 && x < 9 && y >= 2 && y < 7;
      if (rows[y][x] != ' ') CHECK(inside);
      drawn += rows[y][x] != ' ' ? 1u : 0u;
    }
  }
  CHECK(drawn > 15);
}

TEST_CASE("captions: their size is that of the lines that are drawn") {
  CHECK(caption_size(dots(), "aa aa aa", 10) == TextSize{10, 4});
  CHECK(caption_size(dots(), "aa aa aa") == TextSize{16, 2});
  CHECK(caption_size(dots(), "aa\n\na  ") == TextSize{4, 6});
  CHECK(caption_size(dots(), "") == TextSize{0, 0});
  CHECK(caption_size(dots(), "aaa", 0) == TextSize{2, 6});
  Random random(7);
  for (int i = share_of(300); i > 0; --i) {
    std::string text;
    for (std::int32_t n = random.integer(0, 12); n > 0; --n)
      text += std::string("aaa  \n")[random.bits() % 6];
    const std::int32_t columns = random.integer(1, 6);
    const Rows shown = lines(text, columns);
    const TextSize size = caption_size(dots(), text, static_cast<std::uint32_t>(2 * columns));
    std::size_t widest = 0;
    for (const std::string& line : shown) widest = std::max(widest, line.size());
    if (size.height > 20) continue;  // the picture does not show all lines
    CHECK(size.width == 2 * static_cast<std::int32_t>(widest));
    CHECK(size.height >= 2 * static_cast<std::int32_t>(shown.size()));
    std::string letters;
    for (const std::string& line : shown) letters += line;
    CHECK(std::count(letters.begin(), letters.end(), 'a') == std::count(text.begin(), text.end(), 'a'));
  }
}

TEST_CASE("captions: any rectangle is safe") {
  TextPicture picture(16, 8);
  constexpr std::int32_t kSides[] = {INT32_MIN, -100, 3, 9, 100, INT32_MAX};
  for (const std::int32_t left : kSides)
    for (const std::int32_t right : kSides)
      for (const std::int32_t top : kSides)
        for (const std::int32_t bottom : kSides)
          for (const auto vertical :
               {VerticalAlignment::kTop, VerticalAlignment::kMiddle, VerticalAlignment::kBottom})
            CHECK(draw_caption(picture.frame, smooth_font().font, {left, top, right, bottom}, "Li WL\nL",
                               OutlinedText{kInk, TextPicture::kOther},
                               Alignment{HorizontalAlignment::kCentre, vertical}) == Status::kOk);
}
