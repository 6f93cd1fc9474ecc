// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/linux_host/gpio_pin.hpp>
#include <arcspan/linux_host/spi_device.hpp>

#include <catch2/catch.hpp>
#include <tests/linux/guest/tests/guest.hpp>

#include <cerrno>

using namespace arcspan;
using namespace arcspan::linux_host;
using namespace arcspan::test;

namespace {

constexpr const char* kSpi = "/dev/spidev0.0";

std::vector<std::uint8_t> pattern(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  return bytes;
}

void expect(std::vector<std::uint16_t>& words, unsigned level, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) words.push_back(static_cast<std::uint16_t>(level << 8 | byte));
}

}  // namespace

TEST_CASE("a frame reaches the bus byte by byte, each with the right D/C level") {
  BusModels models;
  SpiDevice spi;
  REQUIRE(ok(spi.open(kSpi, {})));
  GpioPin dc;
  REQUIRE(ok(dc.request("DC", hal::Level::kLow)));
  hal::CommandPort port(spi, dc);
  const std::uint8_t parameters[] = {0, 0, 1, 0x3F};
  const std::vector<std::uint8_t> pixels = pattern(3 * spi.chunk_bytes() + 5);
  REQUIRE(spi.chunk_bytes() == 4096);
  CHECK(ok(port.command(0x2A, parameters)));
  CHECK(ok(port.command(0x2C)));
  CHECK(ok(port.data(pixels)));
  std::vector<std::uint16_t> expected{0x2A};
  expect(expected, 1, parameters);
  expected.push_back(0x2C);
  expect(expected, 1, pixels);
  CHECK((models.spi() == expected));
}

TEST_CASE("an error of the bus is told, and the next transfer is right") {
  const std::vector<std::uint8_t> bytes = pattern(10'000);
  SpiDevice spi;
  REQUIRE(ok(spi.open(kSpi, {1'000'000, 1})));
  for (const unsigned at : {0U, 1U, 4095U, 4096U, 9999U}) {
    CAPTURE(at);
    {
      BusModels models;
      models.fail_spi_at(at);
      CHECK(spi.write(bytes) == Status::kTransferFailed);
      CHECK(spi.last_error() == EIO);
      CHECK(models.spi().size() == at);
    }
    {
      BusModels models;
      models.cut_spi_at(at);
      CHECK(spi.write(bytes) == Status::kTransferShort);
      CHECK(spi.last_error() == 0);
      CHECK(models.spi().size() == at);
    }
    BusModels models;
    CHECK(spi.write(bytes) == Status::kOk);
    CHECK(models.spi().size() == bytes.size());
    CHECK(spi.last_error() == 0);
  }
}

TEST_CASE("what cannot be an SPI device is refused with its reason") {
  SpiDevice spi;
  const std::uint8_t byte = 1;
  CHECK(spi.write({&byte, 1}) == Status::kNotReady);
  CHECK(spi.open(kSpi, {1'000'000, 4}).status == Status::kInvalidArgument);
  CHECK(spi.open(kSpi, {0, 0}).status == Status::kInvalidArgument);
  // The model has no inverted clock.
  const Result mode = spi.open(kSpi, {1'000'000, 3});
  CHECK(mode.status == Status::kUnsupported);
  CHECK(mode.text() == "the SPI controller does not have this mode: Invalid argument");
  CHECK(spi.open("/dev/spidev9.9", {}).text() == "cannot be opened: No such file or directory");
  CHECK(spi.open("/dev/null", {}).status == Status::kUnsupported);
  CHECK(spi.write({&byte, 1}) == Status::kNotReady);
  BusModels models;
  CHECK(ok(spi.open(kSpi, {})));
  CHECK(spi.write({&byte, 1}) == Status::kOk);
  CHECK(models.spi().size() == 1);
}
