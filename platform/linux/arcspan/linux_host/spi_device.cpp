// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/spi_device.hpp>

#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace arcspan::linux_host {
namespace {

constexpr std::uint8_t kBitsPerWord = 8;

// Largest message in bytes: a parameter of the spidev module, 4096 by default.
std::size_t message_limit() {
  constexpr std::size_t kDefault = 4096;
  std::FILE* file = std::fopen("/sys/module/spidev/parameters/bufsiz", "re");
  if (file == nullptr) return kDefault;
  char text[16] = {};
  const bool read = std::fgets(text, sizeof text, file) != nullptr;
  std::fclose(file);
  const unsigned long value = read ? std::strtoul(text, nullptr, 10) : 0;
  return value == 0 ? kDefault : value;
}

Result configure(int fd, const SpiSettings& settings) {
  std::uint8_t present = 0;
  if (::ioctl(fd, SPI_IOC_RD_MODE, &present) < 0) {
    return Result::from_errno("is not an SPI device", Status::kUnsupported);
  }
  if (::ioctl(fd, SPI_IOC_WR_MODE, &settings.mode) < 0) {
    return Result::from_errno("the SPI controller does not have this mode", Status::kUnsupported);
  }
  if (::ioctl(fd, SPI_IOC_WR_BITS_PER_WORD, &kBitsPerWord) < 0) {
    return Result::from_errno("the SPI controller does not send bytes", Status::kUnsupported);
  }
  if (::ioctl(fd, SPI_IOC_WR_MAX_SPEED_HZ, &settings.clock_hz) < 0) {
    return Result::from_errno("the SPI controller does not have this clock", Status::kUnsupported);
  }
  return {};
}

}  // namespace

Result SpiDevice::open(const char* path, const SpiSettings& settings) {
  file_.close();
  if (settings.mode > 3 || settings.clock_hz == 0) {
    return Result::refused("SPI mode or clock out of range", Status::kInvalidArgument);
  }
  FileDescriptor file = FileDescriptor::open_device(path);
  if (!file.is_open()) return Result::from_errno("cannot be opened", Status::kNotReady);
  if (const Result result = configure(file.get(), settings); !linux_host::ok(result)) return result;
  chunk_bytes_ = message_limit();
  last_error_ = 0;
  file_ = std::move(file);
  return {};
}

Status SpiDevice::do_write(std::span<const std::uint8_t> bytes) {
  if (!file_.is_open()) return Status::kNotReady;
  while (!bytes.empty()) {
    const std::size_t count = std::min(bytes.size(), chunk_bytes_);
    const Status status = write_chunk(bytes.first(count));
    if (!arcspan::ok(status)) return status;
    bytes = bytes.subspan(count);
  }
  return Status::kOk;
}

Status SpiDevice::write_chunk(std::span<const std::uint8_t> bytes) {
  // Not SPI_IOC_MESSAGE, which returns the requested length whatever the controller sent.
  const ssize_t sent = ::write(file_.get(), bytes.data(), bytes.size());
  last_error_ = sent < 0 ? errno : 0;
  if (sent < 0) return last_error_ == ETIMEDOUT ? Status::kTimeout : Status::kTransferFailed;
  return static_cast<std::size_t>(sent) == bytes.size() ? Status::kOk : Status::kTransferShort;
}

}  // namespace arcspan::linux_host
