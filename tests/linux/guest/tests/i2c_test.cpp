// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/i2c_device.hpp>

#include <catch2/catch.hpp>
#include <tests/linux/guest/tests/guest.hpp>

#include <cerrno>

using namespace arcspan;
using namespace arcspan::linux_host;
using namespace arcspan::test;

namespace {
constexpr const char* kI2c = "/dev/i2c-7";
constexpr std::uint8_t kPanel = 0x3C;
}  // namespace

TEST_CASE("a transaction goes out whole, from start to stop") {
  BusModels models;
  I2cDevice i2c;
  REQUIRE(ok(i2c.open(kI2c)));
  CHECK(ok(i2c.check_free(kPanel)));
  const std::uint8_t command[] = {0x00, 0xAE};
  CHECK(i2c.write(kPanel, command) == Status::kOk);
  std::vector<std::uint16_t> expected{0x13C, 0x00, 0xAE, 0x200};
  CHECK(models.i2c() == expected);
  const std::vector<std::uint8_t> longest(I2cDevice::kMostBytes, 0x40);
  CHECK(i2c.write(kPanel, longest) == Status::kOk);
  CHECK(models.i2c().size() == expected.size() + longest.size() + 2);
}

TEST_CASE("what the bus answers becomes a status, and the next transaction is right") {
  BusModels models;
  I2cDevice i2c;
  const std::uint8_t byte = 1;
  CHECK(i2c.write(kPanel, {&byte, 1}) == Status::kNotReady);
  REQUIRE(ok(i2c.open(kI2c)));
  CHECK(i2c.write(0x3D, {&byte, 1}) == Status::kTransferFailed);  // nobody there
  CHECK(i2c.last_error() == ENXIO);
  models.i2c_error(ETIMEDOUT);
  CHECK(i2c.write(kPanel, {&byte, 1}) == Status::kTimeout);
  models.i2c_error(EIO);
  CHECK(i2c.write(kPanel, {&byte, 1}) == Status::kTransferFailed);
  CHECK(i2c.last_error() == EIO);
  models.i2c_error(0);
  CHECK(i2c.write(kPanel, {&byte, 1}) == Status::kOk);
  CHECK(i2c.last_error() == 0);
  const std::vector<std::uint8_t> too_long(I2cDevice::kMostBytes + 1);
  CHECK(i2c.write(kPanel, too_long) == Status::kUnsupported);
  CHECK(models.i2c() == std::vector<std::uint16_t>{0x13C, 1, 0x200});
}

TEST_CASE("an address that a driver of the kernel owns is busy") {
  I2cDevice i2c;
  CHECK(i2c.check_free(kPanel).status == Status::kNotReady);
  REQUIRE(ok(i2c.open(kI2c)));
  // i2c-core takes the address for a device of any name; "dummy" has a driver of its own.
  write_text("/sys/bus/i2c/devices/i2c-7/new_device", "dummy 0x3c");
  CHECK(i2c.check_free(kPanel).status == Status::kBusy);
  write_text("/sys/bus/i2c/devices/i2c-7/delete_device", "0x3c");
  CHECK(ok(i2c.check_free(kPanel)));
}

TEST_CASE("what is no I2C adapter is refused") {
  I2cDevice i2c;
  CHECK(i2c.open("/dev/i2c-99").status == Status::kNotReady);
  CHECK(i2c.open("/dev/null").text() == "is not an I2C adapter: Inappropriate ioctl for device");
}
