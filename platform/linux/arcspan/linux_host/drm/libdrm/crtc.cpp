// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/libdrm/crtc.hpp>
#include <arcspan/linux_host/drm/output.hpp>

#include <memory>
#include <span>

namespace arcspan::linux_host::drm {
namespace {

// Owns an object of libdrm until the end of the scope.
template <auto kFree>
struct Free {
  template <class Object>
  void operator()(Object* object) const {
    kFree(object);
  }
};
using Resources = std::unique_ptr<drmModeRes, Free<&drmModeFreeResources>>;
using KernelConnector = std::unique_ptr<drmModeConnector, Free<&drmModeFreeConnector>>;
using Encoder = std::unique_ptr<drmModeEncoder, Free<&drmModeFreeEncoder>>;
using Crtc = std::unique_ptr<drmModeCrtc, Free<&drmModeFreeCrtc>>;

constexpr const char* kUnreadable = "the connectors cannot be read";

Result read_connectors(int fd, const drmModeRes& resources, std::vector<KernelConnector>& connectors) {
  for (int i = 0; i < resources.count_connectors; ++i) {
    connectors.emplace_back(::drmModeGetConnector(fd, resources.connectors[i]));
    if (connectors.back() == nullptr) return Result::from_errno(kUnreadable);
  }
  return {};
}

Result read_encoders(int fd, const drmModeConnector& connector, Connector& summary) {
  summary.connected = connector.connection == DRM_MODE_CONNECTED && connector.count_modes > 0;
  for (int i = 0; i < connector.count_encoders; ++i) {
    const Encoder encoder(::drmModeGetEncoder(fd, connector.encoders[i]));
    if (encoder == nullptr) return Result::from_errno(kUnreadable);
    summary.possible_crtcs |= encoder->possible_crtcs;
    if (encoder->encoder_id == connector.encoder_id) summary.crtc = encoder->crtc_id;
  }
  return {};
}

drmModeModeInfo choose_mode_of(const drmModeConnector& connector) {
  std::vector<Mode> modes;
  for (int i = 0; i < connector.count_modes; ++i) {
    const drmModeModeInfo& mode = connector.modes[i];
    modes.push_back({mode.hdisplay, mode.vdisplay, (mode.type & DRM_MODE_TYPE_PREFERRED) != 0});
  }
  return connector.modes[choose_mode(modes)];
}

std::string name_of(const drmModeConnector& connector) {
  const char* type = ::drmModeGetConnectorTypeName(connector.connector_type);
  return std::string(type == nullptr ? "connector" : type) + "-" +
         std::to_string(connector.connector_type_id);
}

}  // namespace

Result CrtcState::apply(int fd) const {
  CrtcState on = *this;  // libdrm's arguments have no const
  const int status = framebuffer == 0 ? ::drmModeSetCrtc(fd, crtc, 0, 0, 0, nullptr, 0, nullptr)
                                      : ::drmModeSetCrtc(fd, crtc, framebuffer, x, y, on.connectors.data(),
                                                         static_cast<int>(on.connectors.size()), &on.mode);
  if (status != 0) return Result::from_errno("the display's mode cannot be set");
  return {};
}

Result choose_display(int fd, CrtcState& before, CrtcState& after, std::string& name) {
  const Resources resources(::drmModeGetResources(fd));
  if (resources == nullptr) return Result::from_errno("has no displays", Status::kUnsupported);
  std::vector<KernelConnector> connectors;
  if (const Result read = read_connectors(fd, *resources, connectors); !linux_host::ok(read)) return read;
  std::vector<Connector> summaries(connectors.size());
  for (std::size_t i = 0; i < connectors.size(); ++i) {
    const Result read = read_encoders(fd, *connectors[i], summaries[i]);
    if (!linux_host::ok(read)) return read;
  }
  const std::span<const std::uint32_t> crtcs(resources->crtcs,
                                             static_cast<std::size_t>(resources->count_crtcs));
  Output output;
  if (const Result chosen = choose_output(summaries, crtcs, output); !linux_host::ok(chosen)) return chosen;

  const Crtc crtc(::drmModeGetCrtc(fd, crtcs[output.crtc]));
  if (crtc == nullptr) return Result::from_errno("the display's mode cannot be read");
  before = {crtc->crtc_id, crtc->mode_valid != 0 ? crtc->buffer_id : 0, crtc->x, crtc->y, crtc->mode, {}};
  for (std::size_t i = 0; i < connectors.size(); ++i) {
    if (summaries[i].crtc == crtc->crtc_id) before.connectors.push_back(connectors[i]->connector_id);
  }
  const drmModeConnector& connector = *connectors[output.connector];
  after = {crtc->crtc_id, 0, 0, 0, choose_mode_of(connector), {connector.connector_id}};
  name = name_of(connector);
  return {};
}

}  // namespace arcspan::linux_host::drm
