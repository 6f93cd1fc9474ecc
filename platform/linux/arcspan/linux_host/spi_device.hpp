// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/spi_bus.hpp>
#include <arcspan/linux_host/file_descriptor.hpp>
#include <arcspan/linux_host/result.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::linux_host {

struct SpiSettings {
  std::uint32_t clock_hz = 10'000'000;  ///< an upper limit: the controller takes the next rate below
  std::uint8_t mode = 0;                ///< 0 ... 3: clock polarity in bit 1, phase in bit 0
};

/// A chip select of an SPI controller, through the kernel's spidev (Documentation/spi/spidev.rst).
///
/// The kernel takes at most `chunk_bytes()` at a time; longer transfers are cut, and chip select is released
/// for a moment between the pieces, which serial panels allow. Transfers block; what the kernel answered to
/// one that failed is in `last_error()`.
class SpiDevice final : public hal::SpiBus {
 public:
  /// Opens `path`, e.g. /dev/spidev0.0, and sets mode, clock and 8 bits a word. kInvalidArgument for a mode
  /// above 3 or a clock of 0; kNotReady if there is no such device or it may not be used; kUnsupported if it
  /// is no spidev or its controller does not have the mode. After a failure the object is closed.
  Result open(const char* path, const SpiSettings& settings);

  /// The errno of the last transfer that failed; 0 if none has, or if it was too short.
  [[nodiscard]] int last_error() const { return last_error_; }
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }

 private:
  /// kNotReady on a closed object, otherwise as SpiBus::write.
  Status do_write(std::span<const std::uint8_t> bytes) override;
  Status write_chunk(std::span<const std::uint8_t> bytes);

  FileDescriptor file_;
  std::size_t chunk_bytes_ = 0;
  int last_error_ = 0;
};

}  // namespace arcspan::linux_host
