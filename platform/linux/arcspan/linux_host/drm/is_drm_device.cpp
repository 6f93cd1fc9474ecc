// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/drm_device.hpp>

#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace arcspan::linux_host {

bool is_drm_device(const char* path) {
  constexpr unsigned kMajor = 226;  // Documentation/admin-guide/devices.txt of Linux
  struct stat status {};
  return ::stat(path, &status) == 0 && S_ISCHR(status.st_mode) && major(status.st_rdev) == kMajor;
}

}  // namespace arcspan::linux_host
