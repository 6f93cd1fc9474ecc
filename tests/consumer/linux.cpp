// SPDX-License-Identifier: MIT
// Somebody's program for a Linux board, and its test: a panel on Linux's devices, and on a mock of them.
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/sim/mock_wires.hpp>
#include <arcspan/linux_host/gpio_pin.hpp>
#include <arcspan/linux_host/monotonic_clock.hpp>
#include <arcspan/linux_host/spi_device.hpp>

#include <cstdio>

using namespace arcspan;

int main() {
  linux_host::SpiDevice spi;
  linux_host::GpioPin dc;
  linux_host::MonotonicClock clock;
  const linux_host::Result opened = spi.open("/dev/null", {});
  const linux_host::Result taken = dc.request("gpiochip4711:0", hal::Level::kLow);
  std::printf("%s; %s\n", opened.text().c_str(), taken.text().c_str());
  hal::Ili9341 panel(spi, dc, nullptr, clock);
  const bool refused = !ok(opened) && !ok(taken) && panel.start() == Status::kNotReady;

  hal::sim::MockWires mock("command 01 = transfer failed\n");
  hal::Ili9341 mocked(mock.spi(), mock.data_or_command(), nullptr, mock.clock());
  const bool failed = mocked.start() == Status::kTransferFailed;
  std::printf("%s\n", mock.finish().c_str());
  return refused && failed && mock.finish().empty() ? 0 : 1;
}
