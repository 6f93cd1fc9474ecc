// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// Settings that can change while a panel runs.
struct PanelSettings {
  Orientation orientation = Orientation::k0;
  bool inverted = false;          ///< complement all colours
  std::uint8_t brightness = 255;  ///< 0 ... 255; ignored if the controller cannot dim
  /// Microseconds after which a transfer is aborted, 1 ... 2^31 - 1.
  std::uint32_t transfer_limit_us = 1'000'000;
};

/// A display behind a bus. A driver derives from it and supplies the `do_...` hooks and `Layout`, a wire
/// layout that decides the byte order of its pixels (wire_layout.hpp). Nothing else in the library has to
/// know the driver.
///
/// After any failure but kBusy the panel assumes that the controller received half a command: the next
/// start_write() or sleep() first sends all settings again, so a frame after a failed one starts clean. Call
/// start() only if the controller lost its supply or start() has not succeeded. Not for interrupt handlers or
/// concurrent threads.
class Panel {
 public:
  /// Resets the controller, sends all settings and switches the display on. Blocks for up to 0.4 s. Works in
  /// any state of the controller, and even if the reset line has no effect. Until it has succeeded, sleep(),
  /// wake() and start_write() return kNotReady.
  ///
  /// - kInvalidArgument: a setting is out of range, or the glass does not fit the controller; nothing is sent
  /// - others: the first failure of the bus or a pin
  Status start();

  /// Switches the display off and lets the controller save power. The controller keeps its picture. kNotReady
  /// before start(); otherwise the first failure of the bus.
  Status sleep();
  /// Wakes the controller; harmless if it is awake. kNotReady before start(); otherwise the first failure of
  /// the bus.
  Status wake();

  /// Changes the settings. They are sent at once if the panel is awake, otherwise by the next wake() or
  /// start(). After a change of orientation the picture is scrambled until it is drawn again.
  /// kInvalidArgument if a value is out of range; nothing is changed then. After a failure the next
  /// start_write() or sleep() sends them; if none may follow soon, call set() again.
  Status set(const PanelSettings& settings);
  [[nodiscard]] const PanelSettings& settings() const { return settings_; }

  /// Size of the picture in pixels, in the present orientation.
  [[nodiscard]] std::int32_t width() const { return turned() ? glass_.height : glass_.width; }
  [[nodiscard]] std::int32_t height() const { return turned() ? glass_.width : glass_.height; }
  [[nodiscard]] Rect bounds() const { return {0, 0, width(), height()}; }
  [[nodiscard]] const Glass& glass() const { return glass_; }

  /// Opens the window `area` of the picture and begins to send its pixels. `wire` holds them as `Layout`
  /// packs them; the caller keeps it unchanged until finish().
  ///
  /// - kInvalidArgument: `area` is empty, outside bounds() or not aligned to the layout, or `wire` has a
  /// wrong size
  /// - kNotReady: the panel is not awake
  /// - kBusy: a transfer is under way
  /// - others: the first failure of the bus or a pin
  Status start_write(const Rect& area, std::span<const std::uint8_t> wire);

  /// Waits for the transfer that start_write() began and returns its result. kOk if there is none, kTimeout
  /// after settings().transfer_limit_us.
  Status finish();

  [[nodiscard]] bool awake() const { return state_ == State::kAwake; }
  /// Whether the next start_write() or sleep() sends all settings first, because a call failed.
  [[nodiscard]] bool needs_configuration() const { return needs_configuration_; }

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
  /// Brings the controller from any state to awake, reset and not yet configured.
  virtual Status do_reset() = 0;
  /// Sends all settings and switches the display on. Where parameters are sent as command bytes, two NOPs
  /// come first: they supply the missing parameters of a command that was cut short.
  virtual Status do_configure() = 0;
  /// Switches the display off and enters sleep mode.
  virtual Status do_sleep() = 0;
  /// Brings the controller from asleep or awake to awake.
  virtual Status do_wake() = 0;
  /// Whether start_write() accepts `area`, which is not empty and inside bounds(), with `bytes` bytes.
  [[nodiscard]] virtual bool do_takes(const Rect& area, std::size_t bytes) const = 0;
  /// Directs the pixels that follow to `area`.
  virtual Status do_open_window(const Rect& area) = 0;
  /// Begins to send pixels, which stay unchanged until do_wait() returns.
  virtual Status do_start_pixels(std::span<const std::uint8_t> wire) = 0;
  /// Waits for the pixels, at most `limit_us` microseconds, and returns the result. kOk if none are under
  /// way.
  virtual Status do_wait(std::uint32_t limit_us) = 0;

  /// Returns `status`; after a failure that may have reached the controller, also sets needs_configuration_.
  Status remember_failure(Status status);
  /// Sends all settings if needs_configuration_ is set, and clears it on success.
  Status configure_if_needed();

  Glass glass_;
  PanelSettings settings_;
  Clock& clock_;
  State state_ = State::kUnknown;
  bool needs_configuration_ = false;
};

}  // namespace arcspan::hal
