// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/animation.hpp>
#include <arcspan_tools/output/frame_folder.hpp>
#include <arcspan_tools/output/frame_output.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

namespace fs = std::filesystem;

/// Frames are kept until all are there, since a GIF's palette depends on all of them: 768 MiB.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

class AnimationFile : public FrameOutput {
 public:
  using Encoder = std::string(std::span<const Image> frames, std::int32_t milliseconds);

  AnimationFile(fs::path path, Encoder* encode, const FrameFormat& format)
      : path_(std::move(path)), encode_(encode), milliseconds_(format.milliseconds) {
    const auto pixels = [](std::int32_t v) { return static_cast<std::uint64_t>(v); };
    if (pixels(format.size.width) * pixels(format.size.height) * format.frames > kMostPixels) {
      throw Failure(path_.string(), "too large an animation (" + std::to_string(format.frames) +
                                        " frames of " + std::to_string(format.size.width) + "x" +
                                        std::to_string(format.size.height) + "; the limit is " +
                                        std::to_string(kMostPixels) + " pixels in all; a folder has none)");
    }
    frames_.reserve(format.frames);
  }
  void add(Image frame) override { frames_.push_back(std::move(frame)); }
  void finish(const std::string& summary) override {
    write_whole_file(path_, encode_(frames_, milliseconds_), summary);
  }

 private:
  fs::path path_;
  Encoder* encode_;
  std::int32_t milliseconds_;
  std::vector<Image> frames_;
};

}  // namespace

bool is_frame_folder(const fs::path& path) {
  std::error_code error;
  return !path.has_filename() || output_kind(path, "png").empty() || fs::is_directory(path, error);
}

std::unique_ptr<FrameOutput> make_frame_output(const fs::path& path, const FrameFormat& format) {
  if (is_frame_folder(path)) return std::make_unique<FrameFolder>(path, format);
  const std::string kind = output_kind(path, "png");
  if (kind == "gif") return std::make_unique<AnimationFile>(path, &encode_gif, format);
  if (kind == "png" || kind == "apng") return std::make_unique<AnimationFile>(path, &encode_apng, format);
  throw Failure(path.string(), "an animation's name must end in .gif or .png, a folder's in a slash");
}

}  // namespace arcspan::tools
