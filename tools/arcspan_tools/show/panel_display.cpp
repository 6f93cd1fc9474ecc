// SPDX-License-Identifier: MIT
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/panel/mipi_dcs.hpp>

#include <arcspan_tools/show/panel_display.hpp>
#include <arcspan_tools/show/panel_wires.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <utility>

namespace arcspan::tools {
namespace {

namespace dcs = hal::dcs;

/// What is particular to a controller of the MIPI display command set and the modules that are sold with it.
struct DcsPanel {
  const char* name;
  Size size;               ///< upright
  dcs::AddressMode mode;   ///< upright
  std::uint32_t reset_us;  ///< the shortest reset
  std::uint32_t ready_ms;  ///< from the reset's end, or waking, to the next command
  std::uint32_t sleep_ms;  ///< from falling asleep to anything else
};

// ILI9341 datasheet V1.11: reset pulse and 120 ms after it, section 15.4; sleep in and out, 8.2.11
// and 8.2.12. The modules' glass is mounted so that columns run backwards and blue comes first.
constexpr DcsPanel kPanels[] = {
    {"ili9341", {240, 320}, {.mirror_columns = true, .blue_first = true}, 10, 120, 5}};

const DcsPanel& find_panel(const std::string& name) {
  for (const DcsPanel& panel : kPanels) {
    if (panel.name == name) return panel;
  }
  std::string names;
  for (const std::string& known : panel_names()) names += ", " + known;
  throw Failure("--device", "expected /dev/..." + names + ", not '" + name + "'");
}

// `upright` turned clockwise. A quarter turn exchanges the axes; half a turn mirrors both.
dcs::AddressMode rotated(dcs::AddressMode upright, int degrees) {
  dcs::AddressMode mode = upright;
  if (degrees == 90 || degrees == 180) mode.mirror_columns = !mode.mirror_columns;
  if (degrees == 180 || degrees == 270) mode.mirror_rows = !mode.mirror_rows;
  mode.swap_axes = degrees == 90 || degrees == 270;
  return mode;
}

class PanelDisplay final : public Display {
 public:
  PanelDisplay(const DcsPanel& panel, const PanelOptions& options)
      : panel_(panel),
        wires_(options),
        port_(wires_.bus(), wires_.data_or_command()),
        size_(panel.size),
        mode_(rotated(panel.mode, options.rotation)) {
    const bool lies = options.rotation == 90 || options.rotation == 270;
    if (lies) std::swap(size_.width, size_.height);
    description_ = std::string("panel ") + panel.name + " at " + options.spi;
  }
  // Not in the constructor: what fails here must put the panel to sleep, too.
  void start() {
    on_ = true;
    reset();
    command(dcs::kSleepOut);
    wires_.clock().delay_ms(panel_.ready_ms);
    command(dcs::kPixelFormatRgb565);
    command(dcs::address_mode(mode_));
    clear();
    command(dcs::kDisplayOn);
  }
  ~PanelDisplay() override {
    if (on_) (void)sleep();
  }

  [[nodiscard]] Size size() const override { return size_; }
  [[nodiscard]] std::string format() const override { return "rgb565"; }
  [[nodiscard]] std::string description() const override { return description_; }

  void show(const Image& image) override {
    const std::int32_t left = (size_.width - image.width) / 2;
    const std::int32_t top = (size_.height - image.height) / 2;
    window(left, top, image.width, image.height);
    send_pixels(image);
    wires_.light(true);  // not before there is something to see
  }

  void finish() override {
    on_ = false;
    wires_.check(sleep());
    wires_.light(false);
  }

 private:
  void command(const dcs::Command& command) {
    wires_.check(port_.command(command.opcode, command.parameters()));
  }

  void reset() {
    if (wires_.reset() != nullptr) {
      wires_.check(wires_.reset()->set(hal::Level::kLow));
      wires_.clock().delay_us(panel_.reset_us);
      wires_.check(wires_.reset()->set(hal::Level::kHigh));
    } else {
      command(dcs::kSoftwareReset);
    }
    wires_.clock().delay_ms(panel_.ready_ms);
  }

  // The controller's memory holds noise after power-on.
  void clear() {
    window(0, 0, size_.width, size_.height);
    const std::vector<std::uint8_t> dark(static_cast<std::size_t>(size_.width) * 2);
    for (std::int32_t y = 0; y < size_.height; ++y) wires_.check(port_.data(dark));
  }

  void window(std::int32_t left, std::int32_t top, std::int32_t width, std::int32_t height) {
    const auto word = [](std::int32_t v) { return static_cast<std::uint16_t>(v); };
    command(dcs::columns(word(left), word(left + width - 1)));
    command(dcs::rows(word(top), word(top + height - 1)));
    command(dcs::kMemoryWrite);
  }

  void send_pixels(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels.size() * 2);
    for (const Rgb8 pixel : image.pixels) {
      const Rgb565::Code code = Rgb565::encode(pixel);
      bytes.push_back(static_cast<std::uint8_t>(code >> 8));
      bytes.push_back(static_cast<std::uint8_t>(code & 0xFF));
    }
    wires_.check(port_.data(bytes));
  }

  Status sleep() {
    Status status = port_.command(dcs::kDisplayOff.opcode);
    if (ok(status)) status = port_.command(dcs::kSleepIn.opcode);
    wires_.clock().delay_ms(panel_.sleep_ms);
    return status;
  }

  const DcsPanel& panel_;
  PanelWires wires_;
  hal::CommandPort port_;
  Size size_;
  dcs::AddressMode mode_;
  std::string description_;
  bool on_ = false;
};

}  // namespace

std::vector<std::string> panel_names() {
  std::vector<std::string> names;
  for (const DcsPanel& panel : kPanels) names.emplace_back(panel.name);
  return names;
}

std::unique_ptr<Display> open_panel_display(const std::string& name, const PanelOptions& options) {
  auto display = std::make_unique<PanelDisplay>(find_panel(name), options);
  display->start();
  return display;
}

}  // namespace arcspan::tools
