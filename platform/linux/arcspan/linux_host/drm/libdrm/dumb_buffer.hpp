// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::linux_host::drm {

/// A picture in memory that every DRM driver can scan out ("dumb buffer", drm-memory of Linux), mapped for
/// the processor. The destructor frees it.
class DumbBuffer {
 public:
  DumbBuffer() = default;
  DumbBuffer(const DumbBuffer&) = delete;
  DumbBuffer& operator=(const DumbBuffer&) = delete;
  ~DumbBuffer() { free(); }

  /// Allocates `width` x `height` black pixels of the card `fd`, which must stay open until free(). `bits` is
  /// 16 for RGB565, 32 for XRGB8888. kBufferTooSmall if the driver has no memory, kUnsupported if it takes no
  /// such picture; then nothing is allocated.
  Result allocate(int fd, std::uint32_t width, std::uint32_t height, std::uint32_t bits);
  void free();

  /// Identifier of the framebuffer for the calls of DRM.
  [[nodiscard]] std::uint32_t id() const { return id_; }
  /// Its mapped bytes.
  [[nodiscard]] void* memory() const { return memory_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Pixels from one row to the next.
  [[nodiscard]] std::int32_t stride() const { return stride_; }

 private:
  Result create(std::uint32_t width, std::uint32_t height, std::uint32_t bits, std::uint32_t& pitch);
  Result map();

  int fd_ = -1;
  std::uint32_t handle_ = 0;  // 0: none
  std::uint32_t id_ = 0;      // 0: none
  void* memory_ = nullptr;
  std::size_t size_ = 0;
  std::int32_t stride_ = 0;
};

}  // namespace arcspan::linux_host::drm
