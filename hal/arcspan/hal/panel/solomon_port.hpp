// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// Port of a Solomon Systech controller that takes parameters as command bytes: SPI with a D/C line, or I2C.
/// Every call returns the first failure of the pin or the bus and then sends nothing more.
class SolomonPort {
 public:
  /// Sends whole commands, at least one byte. Blocks. kBusy while pixels are under way.
  Status command(std::span<const std::uint8_t> bytes) { return do_command(bytes); }
  /// Begins to send pixels, at least one byte. The caller keeps `bytes` unchanged until wait(). May block.
  Status start_pixels(std::span<const std::uint8_t> bytes) { return do_start_pixels(bytes); }
  /// Waits at most `limit_us` microseconds until the pixels are sent and returns the result (SpiBus::wait).
  Status wait(Clock& clock, std::uint32_t limit_us) { return do_wait(clock, limit_us); }

 protected:
  ~SolomonPort() = default;

 private:
  virtual Status do_command(std::span<const std::uint8_t> bytes) = 0;
  virtual Status do_start_pixels(std::span<const std::uint8_t> bytes) = 0;
  virtual Status do_wait(Clock& clock, std::uint32_t limit_us) = 0;
};

/// 4-wire SPI: D/C is low for commands and high for pixels. Bus and pin must outlive the port.
class SolomonSpi final : public SolomonPort {
 public:
  constexpr SolomonSpi(SpiBus& bus, OutputPin& data_or_command) : bus_(bus), dc_(data_or_command) {}

 private:
  Status do_command(std::span<const std::uint8_t> bytes) override;
  Status do_start_pixels(std::span<const std::uint8_t> bytes) override;
  Status do_wait(Clock& clock, std::uint32_t limit_us) override { return bus_.wait(clock, limit_us); }

  SpiBus& bus_;
  OutputPin& dc_;
};

/// I2C: a control byte at the start of each transaction selects commands or pixels (SSD1306 rev 1.1,
/// 8.1.5.2). A transaction holds at most 32 bytes of payload. All calls block. The bus must outlive the port.
class SolomonI2c final : public SolomonPort {
 public:
  static constexpr std::uint8_t kUsualAddress = 0x3C;

  constexpr SolomonI2c(I2cBus& bus, std::uint8_t address) : bus_(bus), address_(address) {}

 private:
  static constexpr std::size_t kBytesAtOnce = 32;

  Status do_command(std::span<const std::uint8_t> bytes) override { return send(0x00, bytes); }
  Status do_start_pixels(std::span<const std::uint8_t> bytes) override { return send(0x40, bytes); }
  Status do_wait(Clock&, std::uint32_t) override { return Status::kOk; }
  Status send(std::uint8_t control, std::span<const std::uint8_t> bytes);

  I2cBus& bus_;
  std::uint8_t address_;
};

}  // namespace arcspan::hal
