// SPDX-License-Identifier: MIT
// Draws docs/images/artefacts.png (CMake target update_pictures): what the papers say of artefacts, by
// Gouraud's method, Phong's and the arcs. Usage: artefact_pictures OUTPUT
#include <arcspan_tools/compare/artefacts.hpp>
#include <arcspan_tools/compare/scan_line_polygon.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/image/label.hpp>

#include <algorithm>
#include <cstdio>

using namespace arcspan;
using namespace arcspan::tools;

namespace {

constexpr const char* kColumns[] = {"gouraud", "phong", "arc"};
constexpr std::int32_t kMargin = 6;
constexpr std::int32_t kText = 4 + kLineHeight;
constexpr Rgb8 kPaper{255, 255, 255};
constexpr Rgb8 kInk{40, 40, 40};

struct Cell {
  std::string label;
  Image image;
};
using Row = std::vector<Cell>;

/// Contrast around a level, so that a kink of the brightness is seen in print.
Image stretched(Image image, int from, int to) {
  for (Rgb8& pixel : image.pixels) {
    if (pixel.g == 0) continue;
    const int level = std::clamp(255 * (pixel.g - from) / (to - from), 0, 255);
    pixel.r = pixel.g = pixel.b = static_cast<std::uint8_t>(level);
  }
  return image;
}

Row mach_bands() {
  Row row;
  for (const char* shading : kColumns) {
    row.push_back({std::string("Mach band, side light: ") + shading,
                   stretched(ArtefactScene::narrow_fold().picture(shading), 100, 255)});
  }
  return row;
}

Row flicker_row(double turn) {
  Row row;
  for (const char* shading : kColumns) {
    row.push_back({"sphere turned by " + std::to_string(static_cast<int>(turn)) + ": " + shading,
                   ArtefactScene::turning_sphere(turn).picture(shading)});
  }
  return row;
}

Row stars() {
  Row row;
  for (const char* shading : kColumns) {
    row.push_back({std::string("round highlight: ") + shading, ArtefactScene::star().picture(shading)});
  }
  return row;
}

Row reflex_corner() {
  const auto whole = [](ScanLineKind kind) {
    return draw_by_scan_lines(concave_polygon(), kind, 0.9, 70.4, 201, 151);
  };
  return {{"polygon as a whole: Gouraud", whole(ScanLineKind::kGouraud)},
          {"polygon as a whole: Phong", whole(ScanLineKind::kPhong)},
          {"two triangles: arc", ArtefactScene::concave().picture("arc")}};
}

Image sheet(const std::vector<Row>& rows) {
  const Image& cell = rows[0][0].image;
  const std::int32_t step_x = cell.width + kMargin;
  const std::int32_t step_y = cell.height + kText + kMargin;
  Image image(kMargin + step_x * static_cast<std::int32_t>(rows[0].size()),
              kMargin + step_y * static_cast<std::int32_t>(rows.size()));
  fill(image, 0, 0, image.width, image.height, kPaper);
  std::int32_t y = kMargin;
  for (const Row& row : rows) {
    std::int32_t x = kMargin;
    for (const Cell& c : row) {
      draw_text(image, x, y, c.label, 1, kInk);
      paste(image, c.image, x, y + kText);
      x += step_x;
    }
    y += step_y;
  }
  return image;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: artefact_pictures OUTPUT\n", stderr);
    return 2;
  }
  try {
    write_image(sheet({mach_bands(), flicker_row(0), flicker_row(15), stars(), reflex_corner()}), argv[1]);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "artefact_pictures: %s\n", e.what());
    return 1;
  }
}
