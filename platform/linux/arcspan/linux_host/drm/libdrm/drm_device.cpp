// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/card_console.hpp>
#include <arcspan/linux_host/drm/drm_device.hpp>
#include <arcspan/linux_host/drm/libdrm/crtc.hpp>
#include <arcspan/linux_host/drm/libdrm/dumb_buffer.hpp>
#include <arcspan/linux_host/drm/libdrm/page_flip.hpp>

#include <xf86drm.h>

namespace arcspan::linux_host {

// The members are released from the last to the first: the console draws again when the card is closed.
struct DrmDevice::State {
  ConsoleGuard console;
  FileDescriptor card;
  std::string driver;
  std::string connector;
  drm::CrtcState before;
  drm::CrtcState shown;  // framebuffer 0 until the first show()
  unsigned bits = 0;
  drm::DumbBuffer buffers[2];
  unsigned hidden = 0;  // index of the buffer that is drawn

  Result open(const char* path);
  Result allocate();
  Result show();
  Result restore() const;
};

namespace {

Result take_master(int fd) {
  // The first program that opens a card is its master already.
  if (::drmIsMaster(fd) != 0 || ::drmSetMaster(fd) == 0) return {};
  return Result::from_errno(
      "another program, such as a desktop, holds the displays; run this on a text console (Ctrl+Alt+F3)",
      Status::kBusy);
}

// 16 if the driver prefers it, as slow buses and small memories do. Every driver takes 32 bits.
unsigned preferred_bits(int fd) {
  std::uint64_t depth = 0;
  return ::drmGetCap(fd, DRM_CAP_DUMB_PREFERRED_DEPTH, &depth) == 0 && depth == 16 ? 16 : 32;
}

}  // namespace

Result DrmDevice::State::open(const char* path) {
  card = FileDescriptor::open_device(path);
  if (!card.is_open()) return Result::from_errno("cannot be opened", Status::kNotReady);
  drmVersion* version = ::drmGetVersion(card.get());
  if (version == nullptr) return Result::from_errno("is not a graphics card", Status::kUnsupported);
  driver = version->name;
  ::drmFreeVersion(version);
  std::uint64_t dumb = 0;
  if (::drmGetCap(card.get(), DRM_CAP_DUMB_BUFFER, &dumb) != 0 || dumb == 0)
    return Result::refused("the driver has no displays, or none for pictures drawn by the processor");
  // Only the master makes the driver look for displays.
  if (const Result result = take_master(card.get()); !linux_host::ok(result)) return result;
  if (const Result result = drm::choose_display(card.get(), before, shown, connector);
      !linux_host::ok(result))
    return result;
  if (const Result result = allocate(); !linux_host::ok(result)) return result;
  drm::stop_console(card.get(), console);
  return {};
}

Result DrmDevice::State::allocate() {
  bits = preferred_bits(card.get());
  for (drm::DumbBuffer& buffer : buffers) {
    const Result result = buffer.allocate(card.get(), shown.mode.hdisplay, shown.mode.vdisplay, bits);
    if (!linux_host::ok(result)) return result;
  }
  return {};
}

Result DrmDevice::State::show() {
  drm::CrtcState next = shown;
  next.framebuffer = buffers[hidden].id();
  const bool is_lit = shown.framebuffer != 0;
  bool flipped = false;
  if (is_lit) {
    const Result result = drm::flip_page(card.get(), next.crtc, next.framebuffer, flipped);
    if (!linux_host::ok(result)) return result;
  }
  // Drivers that cannot flip pages can set a mode.
  if (!flipped) {
    if (const Result result = next.apply(card.get()); !linux_host::ok(result)) return result;
  }
  shown = next;
  hidden ^= 1;
  return {};
}

Result DrmDevice::State::restore() const {
  return shown.framebuffer == 0 ? Result{} : before.apply(card.get());
}

DrmDevice::DrmDevice() = default;
DrmDevice::~DrmDevice() { (void)restore(); }

Result DrmDevice::open(const char* path) {
  (void)restore();
  auto state = std::make_unique<State>();
  const Result result = state->open(path);
  if (linux_host::ok(result)) state_ = std::move(state);
  return result;
}

std::int32_t DrmDevice::width() const { return state_ == nullptr ? 0 : state_->shown.mode.hdisplay; }
std::int32_t DrmDevice::height() const { return state_ == nullptr ? 0 : state_->shown.mode.vdisplay; }
unsigned DrmDevice::bits() const { return state_ == nullptr ? 0 : state_->bits; }

const std::string& DrmDevice::driver() const {
  static const std::string kNone;
  return state_ == nullptr ? kNone : state_->driver;
}
const std::string& DrmDevice::connector() const {
  static const std::string kNone;
  return state_ == nullptr ? kNone : state_->connector;
}

void* DrmDevice::memory() const {
  return state_ == nullptr ? nullptr : state_->buffers[state_->hidden].memory();
}
std::size_t DrmDevice::memory_words() const {
  return state_ == nullptr ? 0 : state_->buffers[state_->hidden].size() / (state_->bits / 8);
}
std::int32_t DrmDevice::stride() const {
  return state_ == nullptr ? 0 : state_->buffers[state_->hidden].stride();
}

Result DrmDevice::show() {
  return state_ == nullptr ? Result::refused("is not open", Status::kNotReady) : state_->show();
}

Result DrmDevice::restore() {
  if (state_ == nullptr) return {};
  const Result result = state_->restore();
  state_ = nullptr;
  return result;
}

}  // namespace arcspan::linux_host
