// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/sheet.hpp>
#include <arcspan_tools/image/label.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace arcspan::tools {
namespace {

constexpr Rgb8 kPaper{24, 26, 30};
constexpr Rgb8 kInk{236, 236, 236};
constexpr Rgb8 kUncovered{58, 60, 66};
constexpr std::int32_t kCellGap = 10;
constexpr std::int32_t kWidestSheet = 16'384;
constexpr std::int64_t kMostSheetPixels = std::int64_t{1} << 28;
constexpr double kBlackUpTo = 0.5;
constexpr std::int32_t kDoublings = 8;

// Dark to bright with rising luma, so that it reads in grey as well.
constexpr Rgb8 kScale[] = {{0, 0, 0},      {30, 20, 90},   {90, 20, 130},  {160, 35, 120}, {215, 60, 80},
                           {245, 105, 40}, {250, 165, 30}, {250, 220, 90}, {255, 255, 255}};

/// Where things stand on the sheet.
struct SheetLayout {
  std::int32_t cell_width;
  std::int32_t cell_height;
  std::int32_t columns;
  std::int32_t rows;
  std::int32_t text_scale;
  std::int32_t text_height;

  SheetLayout(const Comparison& c, std::size_t cells) {
    text_scale = c.width >= 240 ? 2 : 1;
    text_height = text_scale * kLineHeight;
    cell_width = std::max(c.width, 140) + kCellGap;
    // Under the reference stands the scale instead of a map.
    const std::int32_t map_height = std::max(c.height, (kDoublings + 2) * text_height);
    cell_height = c.height + map_height + 2 * text_height + 2 * kCellGap;
    // As wide as high, as far as whole cells go.
    const double ratio = std::sqrt(static_cast<double>(cells) * cell_height / cell_width);
    const auto most = static_cast<std::int32_t>(cells);
    columns = std::clamp(static_cast<std::int32_t>(std::lround(1.3 * ratio)), 1, most);
    rows = (most + columns - 1) / columns;
  }
  [[nodiscard]] std::int32_t width() const { return columns * cell_width + kCellGap; }
  [[nodiscard]] std::int32_t height() const { return rows * cell_height + kCellGap + text_height; }
  [[nodiscard]] std::int32_t x(std::size_t cell) const {
    return kCellGap + static_cast<std::int32_t>(cell) % columns * cell_width;
  }
  [[nodiscard]] std::int32_t y(std::size_t cell) const {
    return kCellGap + text_height + static_cast<std::int32_t>(cell) / columns * cell_height;
  }
};

std::string figures_text(const PictureError& error) {
  char text[64];
  std::snprintf(text, sizeof text, "max %.1f  rms %.2f", error.max, error.rms);
  return text;
}

/// The colours of errors with their steps beside them, from the top of the place down.
void draw_scale(Image& sheet, std::int32_t x, std::int32_t y, const SheetLayout& layout) {
  draw_text(sheet, x, y, "error in steps of 255", layout.text_scale, kInk);
  for (int doubling = 0; doubling <= kDoublings; ++doubling) {
    const double steps = std::ldexp(kBlackUpTo, doubling);
    const std::int32_t top = y + (doubling + 1) * layout.text_height;
    fill(sheet, x, top, 2 * layout.text_height, layout.text_height - 2, error_colour(steps));
    char text[32];
    std::snprintf(text, sizeof text, "%g%s", steps,
                  doubling == 0            ? " or less"
                  : doubling == kDoublings ? " or more"
                                           : "");
    draw_text(sheet, x + 3 * layout.text_height, top, text, layout.text_scale, kInk);
  }
}

void check_size(const SheetLayout& layout) {
  if (layout.width() <= kWidestSheet && layout.height() <= kWidestSheet &&
      std::int64_t{layout.width()} * layout.height() <= kMostSheetPixels) {
    return;
  }
  throw Failure("--size", "the sheet would have " + std::to_string(layout.width()) + "x" +
                              std::to_string(layout.height()) + " pixels; take smaller pictures or fewer");
}

}  // namespace

Rgb8 error_colour(double steps) {
  const double position =
      std::clamp(std::log2(std::max(steps, kBlackUpTo) / kBlackUpTo), 0.0, double{kDoublings});
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(position), std::size(kScale) - 2);
  const double t = position - static_cast<double>(below);
  const auto mix = [t](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
  };
  const Rgb8 a = kScale[below];
  const Rgb8 b = kScale[below + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

Image error_picture(const Image& picture, const ReferencePicture& reference) {
  const std::vector<double> errors = error_map(picture, reference);
  Image map(picture.width, picture.height);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    map.pixels[i] = reference.numbers[i] == 0 ? kUncovered : error_colour(errors[i]);
  }
  return map;
}

Image contact_sheet(const Comparison& comparison, const ReferencePicture& reference) {
  const SheetLayout layout(comparison, comparison.methods.size() + 1);
  check_size(layout);
  Image sheet(layout.width(), layout.height());
  fill(sheet, 0, 0, sheet.width, sheet.height, kPaper);
  draw_text(sheet, kCellGap, kCellGap, comparison.mesh_name, layout.text_scale, kInk);
  const char* reference_name = comparison.reference_kind == ReferenceKind::kPhong
                                   ? "reference: Phong, double"
                                   : "reference: slerp, double";
  draw_text(sheet, layout.x(0), layout.y(0) + kCellGap, reference_name, layout.text_scale, kInk);
  const std::int32_t picture_top = kCellGap + layout.text_height;
  const std::int32_t map_top = picture_top + comparison.height;
  paste(sheet, comparison.reference, layout.x(0), layout.y(0) + picture_top);
  draw_scale(sheet, layout.x(0), layout.y(0) + map_top + kCellGap, layout);
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    const MethodFigures& method = comparison.methods[i];
    const std::int32_t x = layout.x(i + 1);
    const std::int32_t y = layout.y(i + 1);
    draw_text(sheet, x, y + kCellGap, method.shading, layout.text_scale, kInk);
    paste(sheet, method.picture, x, y + picture_top);
    paste(sheet, error_picture(method.picture, reference), x, y + map_top);
    draw_text(sheet, x, y + map_top + comparison.height + 4, figures_text(method.error), layout.text_scale,
              kInk);
  }
  return sheet;
}

}  // namespace arcspan::tools
