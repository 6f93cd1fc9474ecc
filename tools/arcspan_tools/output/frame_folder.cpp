// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/frame_folder.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace arcspan::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& why) {
  throw Failure(folder.string(), "cannot write (" + why + ")");
}

const char* extension_of(ImageFormat format) {
  if (format == ImageFormat::kPpm) return ".ppm";
  return format == ImageFormat::kPgm ? ".pgm" : ".png";
}

}  // namespace

FrameFolder::FrameFolder(const fs::path& folder, const FrameFormat& format)
    : folder_(folder.has_filename() ? folder : folder.parent_path()),
      extension_(extension_of(format.pictures)),
      pictures_(format.pictures) {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  if (fs::exists(status) && !fs::is_directory(status)) fail(folder_, "it is no directory");
  if (fs::exists(status)) refuse_longer_ones(format.frames);
  collected_ = (folder_.parent_path() / ("." + folder_.filename().string() + ".XXXXXX")).string();
  if (::mkdtemp(collected_.data()) == nullptr) {
    const int reason = errno;
    collected_.clear();
    fail(folder_, std::strerror(reason));
  }
}

FrameFolder::~FrameFolder() {
  std::error_code ignored;
  if (!collected_.empty()) fs::remove_all(collected_, ignored);
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
  write_whole_file(fs::path(collected_) / name_of(count_), encode_image(frame, pictures_));
  ++count_;
}

void FrameFolder::finish() {
  try {
    if (!fs::exists(folder_)) {
      // mkdtemp makes folders private; the result gets the mode of a plain mkdir.
      const mode_t mask = ::umask(0);
      ::umask(mask);
      fs::permissions(collected_, static_cast<fs::perms>(0777 & ~mask));
      fs::rename(collected_, folder_);
      collected_.clear();
      return;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      fs::rename(fs::path(collected_) / name_of(i), folder_ / name_of(i));
    }
  } catch (const fs::filesystem_error& e) {
    fail(folder_, e.code().message());
  }
}

}  // namespace arcspan::tools
