// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/file_descriptor.hpp>

namespace arcspan::linux_host {

/// Keeps the kernel's text console from drawing on a framebuffer (KD_GRAPHICS of console_ioctl(2)).
class ConsoleGuard {
 public:
  ConsoleGuard() = default;
  ConsoleGuard(const ConsoleGuard&) = delete;
  ConsoleGuard& operator=(const ConsoleGuard&) = delete;
  ~ConsoleGuard() { release(); }

  /// Does so if the console that is in front draws on the framebuffer `fd`. Does nothing without a console,
  /// or where it may not be asked: the text is then in the picture, as it is with any program.
  void take(int fd);

  /// Puts the console back into the mode it had; the kernel then draws its text anew.
  void release();

  [[nodiscard]] bool is_held() const { return console_.is_open(); }

 private:
  FileDescriptor console_;
  int mode_before_ = 0;
};

}  // namespace arcspan::linux_host
