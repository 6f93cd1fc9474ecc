// SPDX-License-Identifier: MIT
// Calls of DRM that concern one CRTC, with their objects held. Only for sources that are built with libdrm.
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <xf86drmMode.h>

#include <cstdint>
#include <string>
#include <vector>

namespace arcspan::linux_host::drm {

/// Picture, mode and connectors of a CRTC.
struct CrtcState {
  std::uint32_t crtc = 0;         ///< its identifier
  std::uint32_t framebuffer = 0;  ///< 0: it is off
  std::uint32_t x = 0;            ///< of the visible part in the framebuffer
  std::uint32_t y = 0;
  drmModeModeInfo mode{};
  std::vector<std::uint32_t> connectors;

  /// Makes the card `fd` show it. kTransferFailed if the kernel refuses.
  Result apply(int fd) const;
};

/// Reads the connectors of the card `fd` and chooses a display: `before` is the present state of its CRTC,
/// `after` the same CRTC with the display's mode and without a framebuffer, `name` the connector's name, e.g.
/// "HDMI-A-1". kUnsupported if the card has no connectors; other statuses from choose_output().
Result choose_display(int fd, CrtcState& before, CrtcState& after, std::string& name);

}  // namespace arcspan::linux_host::drm
