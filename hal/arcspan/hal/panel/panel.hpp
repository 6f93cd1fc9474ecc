// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// What can be changed while a panel runs.
struct PanelSettings {
  Orientation orientation = Orientation::k0;
  bool inverted = false;          ///< show complements
  std::uint8_t brightness = 255;  ///< 0 ... 255, where the controller has a control for it
  /// A transfer that takes longer is given up, in microseconds, 1 ... 2^31 - 1.
  std::uint32_t transfer_limit_us = 1'000'000;
};

/// A display behind a bus: the cold path of every panel driver. A driver derives from it and supplies the
/// `do_...` hooks and a wire layout (wire_layout.hpp); nothing else of the library has to know it.
///
/// Whatever fails, the status names the cause, and the panel remembers that the controller may have seen half
/// a command: the next call that reaches it sends all settings again first. So a frame after a failed one
/// starts clean, and only a controller that lost its supply or was never started needs `start`.
/// Not for interrupt handlers, not for two threads at once.
class Panel {
 public:
  /// Resets the controller, sends every setting and switches the display on. Takes up to 0.4 s. Works
  /// whatever state the controller is in, also if the reset line does nothing. Until it has succeeded,
  /// everything else but the setters says kNotReady. kInvalidArgument if the glass does not fit the
  /// controller; otherwise what the bus or a pin reports.
  Status start();

  /// Switches the display off and lets the controller save power; its picture is kept.
  /// kNotReady before start().
  Status sleep();
  /// Back from sleep; no harm if awake. kNotReady before start().
  Status wake();

  /// New settings; sent at once if the panel is awake, with the next wake() or start() otherwise. A new
  /// orientation leaves the old picture on the glass in disorder until it is drawn anew.
  /// kInvalidArgument for a value that is none, and nothing is changed.
  Status set(const PanelSettings& settings);
  [[nodiscard]] const PanelSettings& settings() const { return settings_; }

  /// The picture's size in pixels, as the orientation has it.
  [[nodiscard]] std::int32_t width() const { return turned() ? glass_.height : glass_.width; }
  [[nodiscard]] std::int32_t height() const { return turned() ? glass_.width : glass_.height; }
  [[nodiscard]] Rect bounds() const { return {0, 0, width(), height()}; }
  [[nodiscard]] const Glass& glass() const { return glass_; }

  /// Opens the window `area` of the picture, which must lie in bounds() and fit the driver's alignment (else
  /// kInvalidArgument), and begins to send `wire`, the window's pixels as the controller takes them, which
  /// must stay unchanged until finish(). kNotReady unless awake, kBusy while a transfer is under way.
  Status start_write(const Rect& area, std::span<const std::uint8_t> wire);

  /// Waits until what start_write() began is over and gives its result: kOk if nothing was under way,
  /// kTimeout after settings().transfer_limit_us.
  Status finish();

  [[nodiscard]] bool awake() const { return state_ == State::kAwake; }

 protected:
  Panel(const Glass& glass, const PanelSettings& settings, Clock& clock)
      : glass_(glass), settings_(settings), clock_(clock) {}
  ~Panel() = default;

  [[nodiscard]] Clock& clock() { return clock_; }
  [[nodiscard]] bool turned() const { return swaps_axes(settings_.orientation); }

 private:
  enum class State : std::uint8_t { kUnknown, kAsleep, kAwake };

  /// Whether the controller can drive glass().
  [[nodiscard]] virtual bool do_fits() const = 0;
  /// From any state to awake, reset and not yet configured.
  virtual Status do_reset() = 0;
  /// Ends whatever half a command the controller may have seen, sends all settings and display on.
  virtual Status do_configure() = 0;
  virtual Status do_sleep() = 0;
  /// From asleep or awake to awake.
  virtual Status do_wake() = 0;
  /// Whether start_write takes `area`, which lies inside bounds() and is not empty, with `bytes` bytes.
  [[nodiscard]] virtual bool do_takes(const Rect& area, std::size_t bytes) const = 0;
  /// Makes the pixels that follow go to `area`.
  virtual Status do_open_window(const Rect& area) = 0;
  virtual Status do_start_pixels(std::span<const std::uint8_t> wire) = 0;
  virtual Status do_wait(std::uint32_t limit_us) = 0;

  Status note(Status status);
  Status restore();

  Glass glass_;
  PanelSettings settings_;
  Clock& clock_;
  State state_ = State::kUnknown;
  bool in_doubt_ = false;
};

}  // namespace arcspan::hal
