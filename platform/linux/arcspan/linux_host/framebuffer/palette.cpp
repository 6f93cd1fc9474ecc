// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/palette.hpp>

#include <linux/fb.h>
#include <sys/ioctl.h>

namespace arcspan::linux_host {

Result Palette::read(int fd) {
  fb_cmap map{0, 256, red_.data(), green_.data(), blue_.data(), nullptr};
  if (::ioctl(fd, FBIOGETCMAP, &map) < 0) return Result::from_errno("the palette cannot be read");
  return {};
}

Result Palette::write(int fd) const {
  Palette copy = *this;  // the kernel's structure has no const
  fb_cmap map{0, 256, copy.red_.data(), copy.green_.data(), copy.blue_.data(), nullptr};
  if (::ioctl(fd, FBIOPUTCMAP, &map) < 0) return Result::from_errno("the palette cannot be set");
  return {};
}

Palette Palette::rgb332() {
  Palette palette;
  for (unsigned i = 0; i < 256; ++i) {
    palette.red_[i] = static_cast<std::uint16_t>((i >> 5) * 65535 / 7);
    palette.green_[i] = static_cast<std::uint16_t>((i >> 2 & 7) * 65535 / 7);
    palette.blue_[i] = static_cast<std::uint16_t>((i & 3) * 65535 / 3);
  }
  return palette;
}

}  // namespace arcspan::linux_host
