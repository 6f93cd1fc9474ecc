// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace arcspan::tools {

/// Where the frames of a moving picture go, in order: an animation, or a folder of numbered pictures.
class FrameOutput {
 public:
  FrameOutput() = default;
  FrameOutput(const FrameOutput&) = delete;
  FrameOutput& operator=(const FrameOutput&) = delete;
  /// Without finish() nothing is left behind.
  virtual ~FrameOutput() = default;

  /// The next frame, of the size of the first.
  virtual void add(Image frame) = 0;
  /// Prints the command's summary and puts everything in place, whole or not at all.
  virtual void finish(const std::string& summary) = 0;
};

struct FrameFormat {
  std::size_t frames = 0;                    ///< how many will come
  Size size;                                 ///< of each
  std::int32_t milliseconds = 50;            ///< each is shown, 1...65,535
  ImageFormat pictures = ImageFormat::kPng;  ///< of a folder's frames
};

/// Whether `path` is a folder of pictures, as make_frame_output() takes it, or names one.
[[nodiscard]] bool is_frame_folder(const std::filesystem::path& path);

/// By what `path` says: .gif, .png or .apng (animations; also gif:- and png:- on standard output), or a
/// folder if it has no extension, ends in a slash or is one. A folder is made if it is not there and gets
/// frame-0000.png and so on. Throws Failure for other extensions, animations of more than 2^28 pixels in all,
/// and a folder that holds frames with higher numbers, which would end up behind these.
[[nodiscard]] std::unique_ptr<FrameOutput> make_frame_output(const std::filesystem::path& path,
                                                             const FrameFormat& format);

}  // namespace arcspan::tools
