// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/spi_bus.hpp>
#include <arcspan/linux_host/file_descriptor.hpp>
#include <arcspan/linux_host/result.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::linux_host {

struct SpiSettings {
  std::uint32_t clock_hz = 10'000'000;  ///< upper limit; the controller uses the next lower rate
  std::uint8_t mode = 0;                ///< 0 ... 3: clock polarity (CPOL) in bit 1, phase (CPHA) in bit 0
};

/// A chip select of an SPI controller of the kernel's spidev (Documentation/spi/spidev.rst).
///
/// Transfers block. Those longer than chunk_bytes() are split, and chip select is released between the
/// pieces, which serial panels allow. last_error() has the errno of a failed one.
class SpiDevice final : public hal::SpiBus {
 public:
  /// Opens `path`, e.g. /dev/spidev0.0, and sets mode, clock and 8 bits per word. After a failure the object
  /// is closed.
  ///
  /// - kInvalidArgument: the mode is above 3 or the clock is 0
  /// - kNotReady: the device does not exist or may not be used
  /// - kUnsupported: the device is not a spidev, or its controller does not support the settings
  Result open(const char* path, const SpiSettings& settings);

  /// errno of the last transfer that failed; 0 if none has, or if it was only short.
  [[nodiscard]] int last_error() const { return last_error_; }
  /// Largest number of bytes that the kernel sends at once.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }

 private:
  /// Implements SpiBus::write; kNotReady if closed.
  Status do_write(std::span<const std::uint8_t> bytes) override;
  Status write_chunk(std::span<const std::uint8_t> bytes);

  FileDescriptor file_;
  std::size_t chunk_bytes_ = 0;
  int last_error_ = 0;
};

}  // namespace arcspan::linux_host
