// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/output.hpp>

#include <algorithm>

namespace arcspan::linux_host::drm {
namespace {

std::int64_t pixels(const Mode& mode) { return std::int64_t{mode.width} * mode.height; }

// Index of the connector's CRTC, or crtcs.size() if it shows nothing.
std::size_t present_crtc(const Connector& connector, std::span<const std::uint32_t> crtcs) {
  if (connector.crtc == 0) return crtcs.size();
  return static_cast<std::size_t>(std::find(crtcs.begin(), crtcs.end(), connector.crtc) - crtcs.begin());
}

// Index of the first CRTC that can drive `connector` and drives none, or crtcs.size().
std::size_t free_crtc(const Connector& connector, std::span<const Connector> connectors,
                      std::span<const std::uint32_t> crtcs) {
  for (std::size_t i = 0; i < crtcs.size() && i < 32; ++i) {
    const auto shows = [&](const Connector& other) { return other.crtc == crtcs[i]; };
    if ((connector.possible_crtcs >> i & 1) != 0 && std::none_of(connectors.begin(), connectors.end(), shows))
      return i;
  }
  return crtcs.size();
}

}  // namespace

std::size_t choose_mode(std::span<const Mode> modes) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].preferred) return i;
    if (pixels(modes[i]) > pixels(modes[best])) best = i;
  }
  return best;
}

Result choose_output(std::span<const Connector> connectors, std::span<const std::uint32_t> crtcs,
                     Output& output) {
  bool any = false;
  for (const bool lit : {true, false}) {
    for (std::size_t i = 0; i < connectors.size(); ++i) {
      if (!connectors[i].connected) continue;
      any = true;
      const std::size_t crtc =
          lit ? present_crtc(connectors[i], crtcs) : free_crtc(connectors[i], connectors, crtcs);
      if (crtc == crtcs.size()) continue;
      output = {i, crtc};
      return {};
    }
  }
  if (!any) return Result::refused("no display is connected", Status::kNotReady);
  return Result::refused("no CRTC is free for the connected display", Status::kBusy);
}

Result find_stride(std::uint32_t width, std::uint32_t height, std::uint32_t bits, std::uint32_t pitch,
                   std::uint64_t size, std::int32_t& stride) {
  const std::uint32_t bytes = bits / 8;
  if (pitch % bytes != 0 || pitch / bytes < width)
    return Result::refused("the rows of the driver's memory do not hold whole pixels");
  // FramebufferWindow addresses bytes by 32-bit numbers.
  if (std::uint64_t{pitch} * height > size || size > INT32_MAX)
    return Result::refused("the driver's memory has another size than the picture");
  stride = static_cast<std::int32_t>(pitch / bytes);
  return {};
}

}  // namespace arcspan::linux_host::drm
