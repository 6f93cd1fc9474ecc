// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/file_descriptor.hpp>

namespace arcspan::linux_host {

/// Prevents the kernel's text console from drawing on a framebuffer (KD_GRAPHICS, console_ioctl(2)).
class ConsoleGuard {
 public:
  ConsoleGuard() = default;
  ConsoleGuard(const ConsoleGuard&) = delete;
  ConsoleGuard& operator=(const ConsoleGuard&) = delete;
  ~ConsoleGuard() { release(); }

  /// Stops the foreground console if it draws on the framebuffer `fd`. Has no effect without a console or
  /// without the permission to change it; its text then appears in the picture.
  void take(int fd);

  /// Restores the console's mode; the kernel then redraws its text.
  void release();

  [[nodiscard]] bool is_held() const { return console_.is_open(); }

 private:
  FileDescriptor console_;
  int mode_before_ = 0;
};

}  // namespace arcspan::linux_host
