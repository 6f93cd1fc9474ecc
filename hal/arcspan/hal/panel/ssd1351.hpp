// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

namespace arcspan::hal {

/// The usual module of 128 x 128 pixels, with the controller's first row at the bottom and subpixels in the
/// order blue, green, red.
inline constexpr Glass kSsd1351Module{128, 128, 0, 0, false, true, true, false};

/// SSD1351 (Solomon Systech, rev 1.5): 128 x 128 pixels of 16 bits, on 4-wire SPI. The controller performs
/// all four orientations.
class Ssd1351 final : public Panel {
 public:
  using Layout = BigEndianRgb565;
  static constexpr std::int32_t kColumns = 128;
  static constexpr std::int32_t kRows = 128;

  /// `split_coms`: rows are wired to alternating sides of the glass. `reset` is active low and null if not
  /// connected. All referenced objects must outlive the panel.
  Ssd1351(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock,
          const Glass& glass = kSsd1351Module, const PanelSettings& settings = {}, bool split_coms = true)
      : Panel(glass, settings, clock), port_(bus, data_or_command), reset_(reset), split_coms_(split_coms) {}

 private:
  [[nodiscard]] bool do_fits() const override;
  Status do_reset() override;
  Status do_configure() override;
  Status do_sleep() override;
  Status do_wake() override { return Status::kOk; }  // do_configure() leaves sleep mode
  [[nodiscard]] bool do_takes(const Rect& area, std::size_t bytes) const override;
  Status do_open_window(const Rect& area) override;
  Status do_start_pixels(std::span<const std::uint8_t> wire) override { return port_.start_data(wire); }
  Status do_wait(std::uint32_t limit_us) override { return port_.bus().wait(clock(), limit_us); }

  CommandPort port_;
  OutputPin* reset_;
  bool split_coms_;
};

}  // namespace arcspan::hal
