// SPDX-License-Identifier: MIT
// Built without libdrm: open() reports the reason.
#include <arcspan/linux_host/drm/drm_device.hpp>

namespace arcspan::linux_host {

struct DrmDevice::State {
  std::string none;
};

DrmDevice::DrmDevice() = default;
DrmDevice::~DrmDevice() = default;
Result DrmDevice::open(const char*) {
  return Result::refused(
      "graphics cards need libdrm 2.4.112 or later, which was missing when arcspan was built");
}
std::int32_t DrmDevice::width() const { return 0; }
std::int32_t DrmDevice::height() const { return 0; }
unsigned DrmDevice::bits() const { return 0; }
const std::string& DrmDevice::driver() const {
  static const std::string kNone;
  return kNone;
}
const std::string& DrmDevice::connector() const { return driver(); }
void* DrmDevice::memory() const { return nullptr; }
std::size_t DrmDevice::memory_words() const { return 0; }
std::int32_t DrmDevice::stride() const { return 0; }
Result DrmDevice::show() { return Result::refused("is not open", Status::kNotReady); }
Result DrmDevice::restore() { return {}; }

}  // namespace arcspan::linux_host
