// SPDX-License-Identifier: MIT
// Both datasheets state these times: ILI9341 V1.11, 8.2.2 (SWRESET), 8.2.11 (SLPIN), 8.2.12 (SLPOUT) and 15.4
// (reset); ST7789V, 9.1.2, 9.1.11, 9.1.12 and 7.4.5.
#include <arcspan/hal/panel/dcs_panel.hpp>

namespace arcspan::hal {
namespace {

constexpr std::uint32_t kResetPulseUs = 20;     // at least 10
constexpr std::uint32_t kAfterResetMs = 120;    // 5 is enough only if it was asleep, which is unknown
constexpr std::uint32_t kBeforeSleepOutMs = 5;  // after a software reset, even in sleep mode
constexpr std::uint32_t kAfterSleepMs = 120;    // between sleep in and sleep out, in either order

}  // namespace

Status DcsPanel::pulse_reset() {
  Status status = reset_->set(Level::kLow);
  clock().delay_us(kResetPulseUs);
  if (ok(status)) status = reset_->set(Level::kHigh);
  clock().delay_ms(kAfterResetMs);
  return status;
}

Status DcsPanel::reset() {
  Status status = reset_ != nullptr ? pulse_reset() : Status::kOk;
  // Reset by software as well: the reset line may be unconnected.
  if (ok(status)) status = send(dcs::kSoftwareReset);
  if (!ok(status)) return status;
  clock().delay_ms(kAfterResetMs);
  return send_wake();
}

Status DcsPanel::configure() {
  const PanelSettings& s = settings();
  const dcs::AddressMode mode{.mirror_rows = mirrors_rows(glass(), s.orientation),
                              .mirror_columns = mirrors_columns(glass(), s.orientation),
                              .swap_axes = turned(),
                              .blue_first = glass().blue_first};
  const dcs::Command commands[] = {dcs::kPixelFormatRgb565,
                                   dcs::address_mode(mode),
                                   dcs::kNormalMode,
                                   dcs::inversion(s.inverted != glass().inverted),
                                   dcs::brightness(s.brightness),
                                   dcs::kBrightnessControlOn,
                                   dcs::kDisplayOn};
  for (const dcs::Command& command : commands) {
    const Status status = send(command);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

Status DcsPanel::send_sleep() {
  Status status = send(dcs::kDisplayOff);
  if (ok(status)) status = send(dcs::kSleepIn);
  // Wait even after a failure, because the command may have arrived.
  clock().delay_ms(kAfterSleepMs);
  return status;
}

Status DcsPanel::send_wake() {
  clock().delay_ms(kBeforeSleepOutMs);
  const Status status = send(dcs::kSleepOut);
  clock().delay_ms(kAfterSleepMs);
  return status;
}

bool DcsPanel::takes(const Rect& area, std::size_t bytes) const { return bytes == Layout::bytes(area); }

Status DcsPanel::open_window(const Rect& area) {
  const Glass& g = glass();
  const Orientation o = settings().orientation;
  // A mirrored axis counts from the other end of the memory, so the margin at that end comes first.
  const std::int32_t column_margin =
      mirrors_columns(g, o) ? std::int32_t{columns_} - g.width - g.column_offset : g.column_offset;
  const std::int32_t row_margin =
      mirrors_rows(g, o) ? std::int32_t{rows_} - g.height - g.row_offset : g.row_offset;
  const std::int32_t x = turned() ? row_margin : column_margin;
  const std::int32_t y = turned() ? column_margin : row_margin;
  const auto address = [](std::int32_t margin, std::int32_t at) {
    return static_cast<std::uint16_t>(margin + at);
  };
  Status status = send(dcs::columns(address(x, area.left), address(x, area.right - 1)));
  if (ok(status)) status = send(dcs::rows(address(y, area.top), address(y, area.bottom - 1)));
  if (ok(status)) status = send(dcs::kMemoryWrite);
  return status;
}

}  // namespace arcspan::hal
