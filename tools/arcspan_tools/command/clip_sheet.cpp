// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/clip_frames.hpp>
#include <arcspan_tools/command/clip_sheet.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/image/label.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <arcspan_tools/support/text.hpp>

namespace arcspan::tools {
namespace {

constexpr Rgb8 kSheetGround{24, 26, 30};
constexpr Rgb8 kSheetText{236, 236, 236};
constexpr std::int32_t kSheetGap = 6;
constexpr std::int32_t kLargestSheet = 16'384;
constexpr std::size_t kSheetPictures = 8;

/// Where the pictures of a sheet are.
struct SheetGrid {
  Size cell;
  std::int32_t clips = 0;

  [[nodiscard]] std::int32_t row_height() const { return cell.height + 2 * kLineHeight + kSheetGap; }
  [[nodiscard]] std::int32_t width() const {
    return kSheetGap + static_cast<std::int32_t>(kSheetPictures) * (cell.width + kSheetGap);
  }
  [[nodiscard]] std::int32_t height() const { return kSheetGap + clips * row_height(); }
  [[nodiscard]] std::int32_t x(std::size_t picture) const {
    return kSheetGap + static_cast<std::int32_t>(picture) * (cell.width + kSheetGap);
  }
  [[nodiscard]] std::int32_t y(std::size_t clip) const {
    return kSheetGap + static_cast<std::int32_t>(clip) * row_height();
  }
};

SheetGrid grid_of(const RenderOptions& options, std::size_t clips) {
  const SheetGrid grid{options.scene.size, static_cast<std::int32_t>(clips)};
  if (grid.width() <= kLargestSheet && grid.height() <= kLargestSheet) return grid;
  throw Failure("--size", formatted("the sheet of %d clips would have %dx%d pixels; take smaller pictures",
                                    grid.clips, grid.width(), grid.height()));
}

/// The scene with a camera that sees all frames.
Scene scene_of(const RenderOptions& options, const ClipFrames& frames) {
  Scene scene = options.scene;
  const Camera camera = place_camera(scene.camera, frames.positions(), scene.size);
  scene.camera.eye = camera.eye;
  scene.camera.target = camera.target;
  scene.camera.fov_degrees = camera.fov_degrees;
  return scene;
}

}  // namespace

Image clip_sheet(const RenderOptions& options, const Model& model) {
  const std::vector<ClipLength> clips = clips_of(model);
  const SheetGrid grid = grid_of(options, clips.size());
  const Renderer& renderer = find_renderer(options.shading, options.format, options.dither);
  Image sheet(grid.width(), grid.height());
  fill(sheet, 0, 0, sheet.width, sheet.height, kSheetGround);
  Progress progress("drawing", clips.size() * kSheetPictures);
  for (std::size_t row = 0; row < clips.size(); ++row) {
    const ClipLength& clip = clips[row];
    std::vector<double> times;
    for (std::size_t i = 0; i < kSheetPictures; ++i)
      times.push_back(clip.seconds * static_cast<double>(i) / kSheetPictures);
    const ClipFrames frames(model, clip, times, options.crease_degrees, options.mesh);
    const Scene scene = scene_of(options, frames);
    draw_text(sheet, grid.x(0), grid.y(row), printable(clip.name) + formatted(", %g s", clip.seconds), 1,
              kSheetText);
    for (std::size_t i = 0; i < kSheetPictures; ++i) {
      const FixedModel frame = with_outlines(frames.frame(i), options);
      RenderJob job = make_job(scene, frame, options.mesh);
      job.counts = false;
      paste(sheet, renderer.render(job, [](std::size_t) {}).image, grid.x(i), grid.y(row) + kLineHeight);
      draw_text(sheet, grid.x(i), grid.y(row) + kLineHeight + grid.cell.height, formatted("%.3f s", times[i]),
                1, kSheetText);
      progress.show(row * kSheetPictures + i + 1);
    }
  }
  return sheet;
}

}  // namespace arcspan::tools
