// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <array>
#include <cstdint>

namespace arcspan::linux_host {

/// The 256 colours of a framebuffer whose pixels are indices.
class Palette {
 public:
  /// Reads the present colours of the framebuffer `fd`.
  Result read(int fd);
  /// Sets the framebuffer's colours.
  Result write(int fd) const;
  /// The colours that PixelLayout::Kind::kPalette means by rrrgggbb.
  [[nodiscard]] static Palette rgb332();

 private:
  using Levels = std::array<std::uint16_t, 256>;  // 0 ... 65535, as the kernel has them
  Levels red_{};
  Levels green_{};
  Levels blue_{};
};

}  // namespace arcspan::linux_host
