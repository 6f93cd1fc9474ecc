// SPDX-License-Identifier: MIT
// The panel of docs/add-a-panel.md is sent what its data sheet asks for, also after faults.
#include "st7735.hpp"

#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/sim/mock_wires.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <cstdio>
#include <string>

using namespace arcspan;

namespace {

const std::string kReset = "command 01\nwait 125 ms\ncommand 11\nwait 120 ms\n";
const std::string kSettings =
    "command b4\ndata 07\ncommand 26\ndata 01\ncommand 35\ndata 00\n"
    "command 3a\ndata 55\n"
    "command 36\ndata c8\n"  // rows and columns mirrored, blue first
    "command 13\ncommand 20\ncommand 51\ndata ff\ncommand 53\ndata 24\ncommand 29\n";
// The frame of 128x160 pixels in two bands: columns 2 to 129, rows 1 to 80, and 81 to 160.
const std::string kWindow1 = "command 2a\ndata 00 02 00 81\ncommand 2b\ndata 00 01 00 50\ncommand 2c\n";
const std::string kWindow2 = "command 2a\ndata 00 02 00 81\ncommand 2b\ndata 00 51 00 a0\ncommand 2c\n";
const std::string kFrame = kWindow1 + "data f8 00 x10240\n" + kWindow2 + "data f8 00 x10240\n";

std::uint16_t band[hal::Framebuffer<Rgb565>::words(128, 80)];
std::uint8_t wire[hal::wire_bytes<hal::CustomDcsPanel>(128, 80)];

hal::CustomDcsPanel panel_on(hal::sim::MockWires& mock) {
  return {mock.spi(), mock.data_or_command(), nullptr, mock.clock(), kSt7735, kSt7735GreenTab};
}

Status show_red(hal::CustomDcsPanel& panel) {
  hal::PageMode<hal::CustomDcsPanel> pages(panel, band, wire, 80);
  return pages.show([](hal::Framebuffer<Rgb565>& rows) {
    rows.clear({255, 0, 0});
    return Status::kOk;
  });
}

int failures = 0;
void check(bool truth, const std::string& what) {
  if (truth) return;
  std::printf("failed: %s\n", what.c_str());
  ++failures;
}

void start_frame_and_sleep() {
  hal::sim::MockWires mock(kReset + kSettings + kFrame + "command 28\ncommand 10\nwait 120 ms\n");
  hal::CustomDcsPanel panel = panel_on(mock);
  check(panel.start() == Status::kOk && show_red(panel) == Status::kOk && panel.sleep() == Status::kOk,
        "a whole life");
  check(mock.finish().empty(), mock.finish());
}

// After a transfer that fails within a band all settings are sent, then the whole frame.
void fault_in_a_frame() {
  hal::sim::MockWires mock(kReset + kSettings + kWindow1 + "data f8 00 x100 = transfer short\n" + kSettings +
                           kFrame);
  hal::CustomDcsPanel panel = panel_on(mock);
  check(panel.start() == Status::kOk && show_red(panel) == Status::kTransferShort, "the fault is returned");
  check(show_red(panel) == Status::kOk, "the next frame is right");
  check(mock.finish().empty(), mock.finish());
}

void fault_in_the_start() {
  hal::sim::MockWires mock("command 01\nwait 125 ms\ncommand 11 = transfer failed\nwait 120 ms\n");
  hal::CustomDcsPanel panel = panel_on(mock);
  check(panel.start() == Status::kTransferFailed && show_red(panel) == Status::kNotReady, "it is not ready");
  check(mock.finish().empty(), mock.finish());
}

}  // namespace

int main() {
  start_frame_and_sleep();
  fault_in_a_frame();
  fault_in_the_start();
  return failures;
}
