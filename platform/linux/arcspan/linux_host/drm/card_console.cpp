// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/card_console.hpp>

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace arcspan::linux_host::drm {

void stop_console(int fd, ConsoleGuard& guard) {
  struct stat card {};
  if (::fstat(fd, &card) != 0) return;
  // The framebuffer devices of the same hardware, through which the console draws.
  const std::string number = std::to_string(major(card.st_rdev)) + ":" + std::to_string(minor(card.st_rdev));
  std::error_code none;
  for (std::filesystem::directory_iterator entry("/sys/dev/char/" + number + "/device/graphics", none), end;
       entry != end && !none; entry.increment(none)) {
    const FileDescriptor framebuffer =
        FileDescriptor::open_device(("/dev/" + entry->path().filename().string()).c_str());
    if (framebuffer.is_open()) guard.take(framebuffer.get());
    if (guard.is_held()) return;
  }
}

}  // namespace arcspan::linux_host::drm
