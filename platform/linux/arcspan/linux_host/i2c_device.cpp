// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/i2c_device.hpp>

#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <sys/ioctl.h>

#include <cerrno>

namespace arcspan::linux_host {

Result I2cDevice::open(const char* path) {
  file_.close();
  FileDescriptor file = FileDescriptor::open_device(path);
  if (!file.is_open()) return Result::from_errno("cannot be opened", Status::kNotReady);
  unsigned long functions = 0;
  if (::ioctl(file.get(), I2C_FUNCS, &functions) < 0) {
    return Result::from_errno("is not an I2C adapter", Status::kUnsupported);
  }
  if ((functions & I2C_FUNC_I2C) == 0) return Result::refused("the adapter has SMBus commands only");
  last_error_ = 0;
  file_ = std::move(file);
  return {};
}

Result I2cDevice::check_free(std::uint8_t address) {
  if (!file_.is_open()) return Result::refused("is not open", Status::kNotReady);
  if (::ioctl(file_.get(), I2C_SLAVE, static_cast<unsigned long>(address)) < 0) {
    return Result::from_errno("the address is used by the kernel or out of range", Status::kBusy);
  }
  return {};
}

Status I2cDevice::do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) {
  if (!file_.is_open()) return Status::kNotReady;
  if (bytes.size() > kMostBytes) return Status::kUnsupported;
  // The kernel's structure has no const, but a message without I2C_M_RD is only read.
  i2c_msg message{address, 0, static_cast<std::uint16_t>(bytes.size()),
                  const_cast<std::uint8_t*>(bytes.data())};
  i2c_rdwr_ioctl_data transaction{&message, 1};
  const int done = ::ioctl(file_.get(), I2C_RDWR, &transaction);
  last_error_ = done < 0 ? errno : 0;
  if (done == 1) return Status::kOk;
  return last_error_ == ETIMEDOUT ? Status::kTimeout : Status::kTransferFailed;
}

}  // namespace arcspan::linux_host
