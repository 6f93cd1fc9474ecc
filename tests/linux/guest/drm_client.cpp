// SPDX-License-Identifier: MIT
// Another program whose picture is on the graphics card when `arcspan show` comes: it sets a mode of 640x480,
// draws, gives its rights on the card away, and waits for a signal.
#include <arcspan/linux_host/drm/libdrm/crtc.hpp>
#include <arcspan/linux_host/drm/libdrm/dumb_buffer.hpp>
#include <arcspan/linux_host/file_descriptor.hpp>

#include <unistd.h>
#include <xf86drm.h>

#include <cstdio>
#include <stdexcept>

namespace {

using namespace arcspan::linux_host;

constexpr std::uint16_t kWidth = 640;
constexpr std::uint16_t kHeight = 480;

void require(const Result& result) {
  if (!ok(result)) throw std::runtime_error(result.text());
}

drmModeModeInfo small_mode(int card, std::uint32_t connector_id) {
  const drmModeConnector* connector = ::drmModeGetConnector(card, connector_id);
  for (int i = 0; connector != nullptr && i < connector->count_modes; ++i) {
    const drmModeModeInfo& mode = connector->modes[i];
    if (mode.hdisplay == kWidth && mode.vdisplay == kHeight) return mode;
  }
  throw std::runtime_error("no mode of 640x480");
}

void draw(const drm::DumbBuffer& picture) {
  auto* bytes = static_cast<unsigned char*>(picture.memory());
  for (std::size_t i = 0; i < picture.size(); ++i) bytes[i] = static_cast<unsigned char>(i * 31 + i / 251);
}

void run(const char* path) {
  const FileDescriptor card = FileDescriptor::open_device(path);
  drm::CrtcState before;
  drm::CrtcState mine;
  std::string name;
  require(drm::choose_display(card.get(), before, mine, name));
  mine.mode = small_mode(card.get(), mine.connectors.at(0));
  drm::DumbBuffer picture;
  require(picture.allocate(card.get(), kWidth, kHeight, 32));
  draw(picture);
  mine.framebuffer = picture.id();
  require(mine.apply(card.get()));
  if (::drmDropMaster(card.get()) != 0) throw std::runtime_error("cannot give the card away");
  std::puts("ready");
  std::fflush(stdout);
  ::pause();
}

}  // namespace

int main(int, char** argv) {
  try {
    run(argv[1]);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "drm_client: %s\n", e.what());
    return 1;
  }
}
