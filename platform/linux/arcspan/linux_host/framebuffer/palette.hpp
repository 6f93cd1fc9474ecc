// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <array>
#include <cstdint>

namespace arcspan::linux_host {

/// The 256 colours of a framebuffer with indexed pixels.
class Palette {
 public:
  /// Reads the colours of the framebuffer `fd`.
  Result read(int fd);
  /// Sets the colours of the framebuffer `fd`.
  Result write(int fd) const;
  /// Colours for pixels of the form rrrgggbb (PixelLayout::Kind::kPalette).
  [[nodiscard]] static Palette rgb332();

 private:
  using LevelTable = std::array<std::uint16_t, 256>;  // 0 ... 65535, as in the kernel
  LevelTable red_{};
  LevelTable green_{};
  LevelTable blue_{};
};

}  // namespace arcspan::linux_host
