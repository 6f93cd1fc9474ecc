// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/framebuffer_device.hpp>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace arcspan::linux_host {
namespace {

constexpr std::uint32_t kMostPixels = 16384;  // no product below overflows

Result check_size(const fb_fix_screeninfo& fixed, const fb_var_screeninfo& variable, std::size_t row_bytes) {
  if (variable.xres == 0 || variable.yres == 0 || variable.xres > kMostPixels ||
      variable.yres > kMostPixels) {
    return Result::refused("the picture's size is not 1...16384 pixels");
  }
  if (fixed.line_length < row_bytes) return Result::refused("the rows overlap");
  return {};
}

// Repeats pread or pwrite until a whole row is transferred. kTransferShort at the end of the memory.
template <class Call>
Result transfer(Call call, std::size_t count, const char* action) {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t n = call(done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return Result::from_errno(action);
    if (n == 0) return Result::refused(action, Status::kTransferShort);
    done += static_cast<std::size_t>(n);
  }
  return {};
}

}  // namespace

FramebufferDevice::~FramebufferDevice() { (void)restore(); }

Result FramebufferDevice::open(const char* path) {
  (void)restore();
  FileDescriptor file = FileDescriptor::open_device(path);
  if (!file.is_open()) return Result::from_errno("cannot be opened", Status::kNotReady);
  if (const Result result = read_format(file.get()); !linux_host::ok(result)) return result;
  file_ = std::move(file);
  if (const Result result = read_rows(picture_before_); !linux_host::ok(result)) {
    file_.close();
    return result;
  }
  console_.take(file_.get());
  (void)::ioctl(file_.get(), FBIOBLANK, FB_BLANK_UNBLANK);  // not an error: many drivers do not support it
  const Result result = replace_palette(file_.get());
  if (!linux_host::ok(result)) (void)restore();
  return result;
}

Result FramebufferDevice::read_format(int fd) {
  fb_fix_screeninfo fixed{};
  fb_var_screeninfo variable{};
  if (::ioctl(fd, FBIOGET_FSCREENINFO, &fixed) < 0 || ::ioctl(fd, FBIOGET_VSCREENINFO, &variable) < 0) {
    return Result::from_errno("is not a framebuffer", Status::kUnsupported);
  }
  PixelLayout layout;
  if (const Result result = PixelLayout::from_kernel(fixed, variable, layout); !linux_host::ok(result)) {
    return result;
  }
  if (const Result result = check_size(fixed, variable, layout.bytes_per_row(variable.xres));
      !linux_host::ok(result)) {
    return result;
  }
  layout_ = layout;
  width_ = static_cast<std::int32_t>(variable.xres);
  height_ = static_cast<std::int32_t>(variable.yres);
  pitch_ = fixed.line_length;
  origin_ = std::size_t{variable.yoffset} * pitch_ + std::size_t{variable.xoffset} * layout.bits / 8;
  std::memcpy(name_, fixed.id, sizeof fixed.id);
  return {};
}

Result FramebufferDevice::replace_palette(int fd) {
  if (layout_.kind != PixelLayout::Kind::kPalette) return {};
  const Result result = palette_before_.read(fd);
  return linux_host::ok(result) ? Palette::rgb332().write(fd) : result;
}

std::size_t FramebufferDevice::position(std::int32_t row) const {
  return origin_ + static_cast<std::size_t>(row) * pitch_;
}

Result FramebufferDevice::write_rows(std::int32_t first, std::span<const std::uint8_t> rows) {
  if (!file_.is_open()) return Result::refused("is not open", Status::kNotReady);
  const std::size_t bytes = bytes_per_row();
  const std::size_t count = rows.size() / bytes;
  if (rows.size() % bytes != 0 || first < 0 || first > height_ ||
      count > static_cast<std::size_t>(height_ - first)) {
    return Result::refused("rows outside the picture", Status::kInvalidArgument);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = position(first + static_cast<std::int32_t>(i));
    const auto write = [&](std::size_t done) {
      return ::pwrite(file_.get(), rows.data() + i * bytes + done, bytes - done,
                      static_cast<off_t>(at + done));
    };
    if (const Result result = transfer(write, bytes, "pixels cannot be written"); !linux_host::ok(result)) {
      return result;
    }
  }
  return {};
}

Result FramebufferDevice::read_rows(std::vector<std::uint8_t>& rows) {
  if (!file_.is_open()) return Result::refused("is not open", Status::kNotReady);
  const std::size_t bytes = bytes_per_row();
  rows.resize(bytes * static_cast<std::size_t>(height_));
  for (std::int32_t y = 0; y < height_; ++y) {
    std::uint8_t* row = rows.data() + bytes * static_cast<std::size_t>(y);
    const auto read = [&](std::size_t done) {
      return ::pread(file_.get(), row + done, bytes - done, static_cast<off_t>(position(y) + done));
    };
    if (const Result result = transfer(read, bytes, "pixels cannot be read"); !linux_host::ok(result)) {
      return result;
    }
  }
  return {};
}

Result FramebufferDevice::restore() {
  if (!file_.is_open()) return {};
  Result result;
  if (layout_.kind == PixelLayout::Kind::kPalette) result = palette_before_.write(file_.get());
  const std::size_t bytes = bytes_per_row();
  for (std::int32_t y = 0; y < height_; ++y) {
    const std::uint8_t* const row = picture_before_.data() + bytes * static_cast<std::size_t>(y);
    const Result written = write_rows(y, {row, bytes});
    if (linux_host::ok(result)) result = written;
  }
  console_.release();
  file_.close();
  picture_before_.clear();
  width_ = height_ = 0;
  return result;
}

}  // namespace arcspan::linux_host
