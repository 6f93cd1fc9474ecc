// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/console_guard.hpp>

#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <utility>

namespace arcspan::linux_host {
namespace {

// Minor number of the framebuffer that the foreground console draws on, or -1 if there is none.
int front_framebuffer(int console, int framebuffer) {
  vt_stat state{};
  if (::ioctl(console, VT_GETSTATE, &state) < 0) return -1;
  fb_con2fbmap map{state.v_active, 0};
  if (::ioctl(framebuffer, FBIOGET_CON2FBMAP, &map) < 0) return -1;
  return static_cast<int>(map.framebuffer);
}

bool has_minor_number(int framebuffer, int number) {
  struct stat status {};
  return ::fstat(framebuffer, &status) == 0 && static_cast<int>(minor(status.st_rdev)) == number;
}

}  // namespace

void ConsoleGuard::take(int fd) {
  release();
  FileDescriptor console = FileDescriptor::open_device("/dev/tty0");
  if (!console.is_open() || !has_minor_number(fd, front_framebuffer(console.get(), fd))) return;
  if (::ioctl(console.get(), KDGETMODE, &mode_before_) < 0) return;
  if (::ioctl(console.get(), KDSETMODE, KD_GRAPHICS) < 0) return;
  console_ = std::move(console);
}

void ConsoleGuard::release() {
  if (!console_.is_open()) return;
  (void)::ioctl(console_.get(), KDSETMODE, mode_before_);
  console_.close();
}

}  // namespace arcspan::linux_host
