// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/libdrm/dumb_buffer.hpp>
#include <arcspan/linux_host/drm/output.hpp>

#include <drm_fourcc.h>
#include <sys/mman.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstring>

namespace arcspan::linux_host::drm {

Result DumbBuffer::allocate(int fd, std::uint32_t width, std::uint32_t height, std::uint32_t bits) {
  free();
  fd_ = fd;
  std::uint32_t pitch = 0;
  Result result = create(width, height, bits, pitch);
  if (linux_host::ok(result)) result = find_stride(width, height, bits, pitch, size_, stride_);
  if (linux_host::ok(result)) result = map();
  if (!linux_host::ok(result)) {
    free();
    return result;
  }
  const std::uint32_t format = bits == 16 ? DRM_FORMAT_RGB565 : DRM_FORMAT_XRGB8888;
  const std::uint32_t handles[4] = {handle_};
  const std::uint32_t pitches[4] = {pitch};
  const std::uint32_t offsets[4] = {};
  if (::drmModeAddFB2(fd, width, height, format, handles, pitches, offsets, &id_, 0) != 0) {
    result = Result::from_errno("the driver does not take the picture's format", Status::kUnsupported);
    free();
  }
  return result;
}

Result DumbBuffer::create(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                          std::uint32_t& pitch) {
  drm_mode_create_dumb request{};
  request.width = width;
  request.height = height;
  request.bpp = bits;
  if (::drmIoctl(fd_, DRM_IOCTL_MODE_CREATE_DUMB, &request) != 0)
    return Result::from_errno("the driver has no memory for the picture", Status::kBufferTooSmall);
  handle_ = request.handle;
  size_ = static_cast<std::size_t>(request.size);
  pitch = request.pitch;
  return {};
}

Result DumbBuffer::map() {
  drm_mode_map_dumb request{};
  request.handle = handle_;
  if (::drmIoctl(fd_, DRM_IOCTL_MODE_MAP_DUMB, &request) != 0)
    return Result::from_errno("the driver's memory cannot be mapped", Status::kBufferTooSmall);
  void* memory =
      ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, fd_, static_cast<off_t>(request.offset));
  if (memory == MAP_FAILED)
    return Result::from_errno("the driver's memory cannot be mapped", Status::kBufferTooSmall);
  memory_ = memory;
  std::memset(memory_, 0, size_);  // video memory may hold old pictures
  return {};
}

void DumbBuffer::free() {
  if (id_ != 0) (void)::drmModeRmFB(fd_, id_);
  if (memory_ != nullptr) ::munmap(memory_, size_);
  if (handle_ != 0) {
    drm_mode_destroy_dumb request{};
    request.handle = handle_;
    (void)::drmIoctl(fd_, DRM_IOCTL_MODE_DESTROY_DUMB, &request);
  }
  id_ = handle_ = 0;
  memory_ = nullptr;
  size_ = 0;
  stride_ = 0;
}

}  // namespace arcspan::linux_host::drm
