// SPDX-License-Identifier: MIT
// On a board: sends a frame through spidev and libgpiod. With an argument, on any machine: writes to that
// file what has to be seen on the wires, 16-bit words: D/C level << 8 | byte.
#include "board_frame.hpp"

#include <arcspan/linux_host/gpio_pin.hpp>
#include <arcspan/linux_host/monotonic_clock.hpp>
#include <arcspan/linux_host/spi_device.hpp>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

using namespace arcspan;
using namespace arcspan::linux_host;

namespace {

class RememberedPin final : public hal::OutputPin {
 public:
  [[nodiscard]] unsigned level() const { return level_; }

 private:
  Status do_set(hal::Level level) override {
    level_ = level == hal::Level::kHigh ? 1 : 0;
    return Status::kOk;
  }
  unsigned level_ = 0;
};

class FileBus final : public hal::SpiBus {
 public:
  FileBus(std::FILE* out, const RememberedPin& dc) : out_(out), dc_(dc) {}

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) {
      std::fputc(byte, out_);
      std::fputc(static_cast<int>(dc_.level()), out_);
    }
    return Status::kOk;
  }
  std::FILE* out_;
  const RememberedPin& dc_;
};

Status write_expected(const char* path) {
  std::FILE* out = std::fopen(path, "wb");
  if (out == nullptr) return Status::kTransferFailed;
  RememberedPin dc;
  RememberedPin other;
  FileBus bus(out, dc);
  MonotonicClock clock;
  const Status status = test::send_frame({bus, dc, other, other, clock});
  return std::fclose(out) == 0 ? status : Status::kTransferFailed;
}

bool said(const char* what, const Result& result) {
  if (!ok(result)) std::printf("%s: %s\n", what, result.text().c_str());
  return ok(result);
}

Status run_on_board() {
  SpiDevice spi;
  GpioPin dc;
  GpioPin reset;
  GpioPin backlight;
  MonotonicClock clock;
  if (!said("spi", spi.open("/dev/spidev0.0", {1'000'000, 0})) ||
      !said("DC", dc.request("DC", hal::Level::kLow)) ||
      !said("RESET", reset.request("RESET", hal::Level::kHigh)) ||
      !said("BACKLIGHT", backlight.request("gpiochip0:5", hal::Level::kLow))) {
    return Status::kNotReady;
  }
  return test::send_frame({spi, dc, reset, backlight, clock});
}

// As the first process of a guest that holds nothing else.
void prepare_guest() {
  ::mkdir("/dev", 0755);
  ::mount("dev", "/dev", "devtmpfs", 0, nullptr);
  ::mkdir("/sys", 0755);
  ::mount("sys", "/sys", "sysfs", 0, nullptr);  // libgpiod 1 looks there
  const int console = ::open("/dev/console", O_RDWR);
  for (const int fd : {0, 1, 2}) ::dup2(console, fd);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) return ok(write_expected(argv[1])) ? 0 : 1;
  const bool first = ::getpid() == 1;
  if (first) prepare_guest();
  const Status status = run_on_board();
  std::printf("libgpiod %s, %zu bits: %s\nguest: exit %d\n", gpio::version(), sizeof(void*) * 8,
              to_string(status), ok(status) ? 0 : 1);
  std::fflush(stdout);
  if (first) {
    ::sync();
    ::reboot(RB_POWER_OFF);
  }
  return ok(status) ? 0 : 1;
}
