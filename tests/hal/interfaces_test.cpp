// SPDX-License-Identifier: MIT
#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

using namespace arcspan;
using namespace arcspan::hal;

namespace {

using Bytes = std::vector<std::uint8_t>;

class ManualClock final : public Clock {
 public:
  explicit ManualClock(std::uint32_t now) : now_(now) {}
  std::vector<std::uint32_t> delays;

 private:
  std::uint32_t do_now_us() override { return now_; }
  void do_delay_us(std::uint32_t us) override {
    delays.push_back(us);
    now_ += us;
  }
  std::uint32_t now_;
};

/// Implements the one hook that a bus must.
class BlockingSpi final : public SpiBus {
 public:
  Bytes sent;
  Status result = Status::kOk;

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override {
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    return result;
  }
};

/// Is busy for a number of polls, then tells `result`.
class SlowSpi final : public SpiBus {
 public:
  int polls_left = 0;
  int starts = 0;
  int writes = 0;
  int aborts = 0;
  Status start_result = Status::kOk;
  Status result = Status::kOk;

 private:
  Status do_write(std::span<const std::uint8_t>) override { return ++writes, Status::kOk; }
  Status do_start(std::span<const std::uint8_t>) override { return ++starts, start_result; }
  Status do_poll() override { return polls_left-- > 0 ? Status::kBusy : result; }
  void do_abort() override { ++aborts; }
};

/// Gives the processor away while it waits, as on an operating system, for `nap` microseconds at a time.
class SleepingSpi final : public SpiBus {
 public:
  explicit SleepingSpi(std::uint32_t nap) : nap_(nap) {}
  int polls_left = 0;
  std::vector<std::uint32_t> lefts;

 private:
  Status do_write(std::span<const std::uint8_t>) override { return Status::kOk; }
  Status do_start(std::span<const std::uint8_t>) override { return Status::kOk; }
  Status do_poll() override { return polls_left-- > 0 ? Status::kBusy : Status::kOk; }
  void do_pause(Clock& clock, std::uint32_t left_us) override {
    lefts.push_back(left_us);
    clock.delay_us(std::min(nap_, left_us));
  }
  std::uint32_t nap_;
};

class CountingI2c final : public I2cBus {
 public:
  int writes = 0;

 private:
  Status do_write(std::uint8_t, std::span<const std::uint8_t>) override {
    return ++writes, Status::kTransferShort;
  }
};

class CountingPin final : public OutputPin {
 public:
  std::vector<Level> levels;
  Status result = Status::kOk;

 private:
  Status do_set(Level level) override { return levels.push_back(level), result; }
};

const std::array<std::uint8_t, 3> kBytes{1, 2, 3};

}  // namespace

// Deleting a seam through its base would pull in operator delete.
static_assert(!std::is_destructible_v<SpiBus> && !std::is_destructible_v<I2cBus>);
static_assert(!std::is_destructible_v<OutputPin> && !std::is_destructible_v<Clock>);

TEST_CASE("a bus that can only block has finished when start returns, which returns the result") {
  BlockingSpi bus;
  ManualClock clock(0);
  CHECK(bus.start(kBytes) == Status::kOk);
  CHECK(bus.sent == Bytes{1, 2, 3});
  CHECK(bus.wait(clock, 0) == Status::kOk);
  CHECK(clock.delays.empty());
  bus.result = Status::kTransferShort;
  CHECK(bus.start(kBytes) == Status::kTransferShort);
  CHECK_FALSE(bus.under_way());
  CHECK(bus.write(kBytes) == Status::kTransferShort);
}

TEST_CASE("an empty transfer is refused without using the bus") {
  SlowSpi bus;
  CHECK(bus.write({}) == Status::kInvalidArgument);
  CHECK(bus.start({}) == Status::kInvalidArgument);
  CHECK(bus.starts + bus.writes == 0);
}

TEST_CASE("a transfer under way is left alone") {
  SlowSpi bus;
  bus.polls_left = 1;
  REQUIRE(bus.start(kBytes) == Status::kOk);
  CHECK(bus.start(kBytes) == Status::kBusy);
  CHECK(bus.write(kBytes) == Status::kBusy);
  CHECK(bus.starts == 1);
  CHECK(bus.writes == 0);
  CHECK(bus.poll() == Status::kBusy);
  CHECK(bus.poll() == Status::kOk);
  CHECK(bus.write(kBytes) == Status::kOk);
}

TEST_CASE("a transfer's failure is returned once and frees the bus") {
  SlowSpi bus;
  bus.result = Status::kTransferFailed;
  REQUIRE(bus.start(kBytes) == Status::kOk);
  CHECK(bus.poll() == Status::kTransferFailed);
  CHECK(bus.poll() == Status::kOk);
  bus.start_result = Status::kTransferFailed;
  CHECK(bus.start(kBytes) == Status::kTransferFailed);
  CHECK_FALSE(bus.under_way());
}

TEST_CASE("waiting gives a transfer up at its limit, also when the clock wraps meanwhile") {
  const std::uint32_t begin = GENERATE(0U, UINT32_MAX - 15U);
  ManualClock clock(begin);
  SlowSpi bus;
  bus.polls_left = 3;
  REQUIRE(bus.start(kBytes) == Status::kOk);
  SECTION("in time") {
    CHECK(bus.wait(clock, 30) == Status::kOk);
    CHECK(clock.now_us() - begin == 30);
    CHECK(bus.aborts == 0);
  }
  SECTION("too late") {
    CHECK(bus.wait(clock, 20) == Status::kTimeout);
    CHECK(clock.now_us() - begin == 20);
    CHECK(bus.aborts == 1);
    CHECK(bus.start(kBytes) == Status::kOk);
  }
  SECTION("limit out of range") {
    CHECK(bus.wait(clock, 0x8000'0000U) == Status::kInvalidArgument);
    CHECK(bus.under_way());
  }
}

TEST_CASE("a bus that gives the processor away is told how long the transfer may still take") {
  using Lefts = std::vector<std::uint32_t>;
  const std::uint32_t begin = GENERATE(0U, UINT32_MAX - 15U);
  ManualClock clock(begin);
  SleepingSpi bus(40);
  bus.polls_left = 3;
  REQUIRE(bus.start(kBytes) == Status::kOk);
  SECTION("in time") {
    CHECK(bus.wait(clock, 1000) == Status::kOk);
    CHECK(bus.lefts == Lefts{1000, 960, 920});
  }
  SECTION("too late") {
    CHECK(bus.wait(clock, 60) == Status::kTimeout);
    CHECK(bus.lefts == Lefts{60, 20});
  }
}

TEST_CASE("an I2C bus refuses reserved addresses and empty transactions") {
  CountingI2c bus;
  for (int address = 0; address < 256; ++address) {
    const int before = bus.writes;
    const bool valid = address >= 0x08 && address <= 0x77;
    CHECK(bus.write(static_cast<std::uint8_t>(address), kBytes) ==
          (valid ? Status::kTransferShort : Status::kInvalidArgument));
    CHECK(bus.writes - before == (valid ? 1 : 0));
  }
  CHECK(bus.write(0x3C, {}) == Status::kInvalidArgument);
}

TEST_CASE("a pin refuses a value that is no level and passes on its failure") {
  CountingPin pin;
  CHECK(pin.set(static_cast<Level>(2)) == Status::kInvalidArgument);
  CHECK(pin.levels.empty());
  CHECK(pin.set(Level::kHigh) == Status::kOk);
  pin.result = Status::kTransferFailed;
  CHECK(pin.set(Level::kLow) == Status::kTransferFailed);
  CHECK(pin.levels == std::vector{Level::kHigh, Level::kLow});
}

TEST_CASE("a delay of zero does not wait, and one that is too long saturates") {
  ManualClock clock(0);
  clock.delay_us(0);
  clock.delay_ms(0);
  CHECK(clock.delays.empty());
  clock.delay_ms(4'294'967);
  clock.delay_ms(4'294'968);
  CHECK(clock.delays == std::vector<std::uint32_t>{4'294'967'000U, UINT32_MAX});
}
