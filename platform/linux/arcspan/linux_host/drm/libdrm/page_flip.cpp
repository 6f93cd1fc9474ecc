// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/libdrm/page_flip.hpp>

#include <poll.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cerrno>
#include <cstring>

namespace arcspan::linux_host::drm {
namespace {

constexpr int kLongestWaitMs = 1000;
constexpr Result kDone{};

// Whether the first `count` of the bytes read, whole events, have the end of the flip to `framebuffer`.
// drmHandleEvent() would write to an address given with the flip, also when nobody waits for it any more.
bool has_flip(const char* events, std::size_t count, std::uint32_t framebuffer) {
  drm_event_vblank event{};
  for (std::size_t at = 0; at + sizeof event.base <= count; at += event.base.length) {
    std::memcpy(&event.base, events + at, sizeof event.base);
    if (event.base.length < sizeof event.base) return false;
    if (event.base.type != DRM_EVENT_FLIP_COMPLETE || at + sizeof event > count) continue;
    std::memcpy(&event, events + at, sizeof event);
    if (event.user_data == framebuffer) return true;
  }
  return false;
}

Result wait_for_flip(int fd, std::uint32_t framebuffer) {
  while (true) {
    pollfd card{fd, POLLIN, 0};
    const int ready = ::poll(&card, 1, kLongestWaitMs);
    if (ready == 0) return Result::refused("the display does not show the picture", Status::kTimeout);
    alignas(drm_event_vblank) char events[1024];
    const ssize_t count = ready < 0 ? -1 : ::read(fd, events, sizeof events);
    if (count < 0 && errno != EINTR && errno != EAGAIN)
      return Result::from_errno("the display's events cannot be read");
    if (count > 0 && has_flip(events, static_cast<std::size_t>(count), framebuffer)) return kDone;
  }
}

}  // namespace

Result flip_page(int fd, std::uint32_t crtc, std::uint32_t framebuffer, bool& flipped) {
  void* event = reinterpret_cast<void*>(std::uintptr_t{framebuffer});  // a number, not an address
  flipped = ::drmModePageFlip(fd, crtc, framebuffer, DRM_MODE_PAGE_FLIP_EVENT, event) == 0;
  return flipped ? wait_for_flip(fd, framebuffer) : kDone;
}

}  // namespace arcspan::linux_host::drm
