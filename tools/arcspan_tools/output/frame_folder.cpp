// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/frame_folder.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <sys/stat.h>

#include <cstdio>

namespace arcspan::tools {
namespace {

namespace fs = std::filesystem;

const char* extension_of(ImageFormat format) {
  if (format == ImageFormat::kPpm) return ".ppm";
  return format == ImageFormat::kPgm ? ".pgm" : ".png";
}

}  // namespace

FrameFolder::FrameFolder(const fs::path& folder, const FrameFormat& format)
    : folder_(destination(folder.has_filename() ? folder : folder.parent_path())),
      extension_(extension_of(format.pictures)),
      pictures_(format.pictures) {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  exists_ = fs::exists(status);
  if (exists_ && !fs::is_directory(status))
    throw Failure(folder.string(), "cannot write (it is no directory)");
  if (exists_) refuse_longer_ones(format.frames);
  collected_.emplace(exists_ ? folder_ : folder_.parent_path(), folder);
}

std::string FrameFolder::name_of(std::size_t number) const {
  char digits[32];
  std::snprintf(digits, sizeof digits, "frame-%04zu", number);
  return digits + extension_;
}

void FrameFolder::refuse_longer_ones(std::size_t frames) const {
  std::error_code error;
  const std::string next = name_of(frames);
  if (fs::exists(folder_ / next, error)) {
    throw Failure(folder_.string(), "holds " + next + " of a longer animation; remove it first");
  }
}

void FrameFolder::add(Image frame) {
  const std::string name = name_of(frames_.size());
  frames_.push_back(&collected_->file(name));
  write_new_file(frames_.back()->path(), encode_image(frame, pictures_), folder_ / name);
}

void FrameFolder::finish(const std::string& summary) {
  if (exists_) {
    std::vector<FilePlacement> placements;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      placements.push_back({*frames_[i], folder_ / name_of(i), folder_ / name_of(i)});
    }
    return place_all(placements, summary, stdout);
  }
  // mkdtemp makes folders private; the result gets the mode of a plain mkdir.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::chmod(collected_->path().c_str(), 0777u & ~mask) != 0) fail_with_errno(folder_, "write");
  place_all({{collected_->folder(), folder_, folder_}}, summary, stdout);
  for (Removal* frame : frames_) frame->cancel();
}

}  // namespace arcspan::tools
