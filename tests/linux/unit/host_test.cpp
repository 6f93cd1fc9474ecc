// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/file_descriptor.hpp>
#include <arcspan/linux_host/framebuffer/framebuffer_device.hpp>
#include <arcspan/linux_host/gpio/line_name.hpp>
#include <arcspan/linux_host/gpio_pin.hpp>
#include <arcspan/linux_host/i2c_device.hpp>
#include <arcspan/linux_host/monotonic_clock.hpp>
#include <arcspan/linux_host/signal_watch.hpp>
#include <arcspan/linux_host/spi_device.hpp>

#include <catch2/catch.hpp>
#include <sys/time.h>

#include <cerrno>
#include <csignal>
#include <optional>

using namespace arcspan;
using namespace arcspan::linux_host;

TEST_CASE("a failure names the attempted call and the answer of the kernel") {
  errno = ENODEV;
  CHECK(Result::from_errno("cannot be opened").text() == "cannot be opened: No such device");
  CHECK(Result::refused("is not open").text() == "is not open");
  CHECK(ok(Result{}));
  CHECK_FALSE(ok(Result::refused("x")));
}

TEST_CASE("addresses of lines are distinguished from names") {
  using gpio::LineAddress;
  using gpio::parse_line_address;
  CHECK(parse_line_address("gpiochip0:25") == LineAddress{"/dev/gpiochip0", 25});
  CHECK(parse_line_address("/dev/gpiochip12:0") == LineAddress{"/dev/gpiochip12", 0});
  CHECK(parse_line_address("gpiochip0:65535") == LineAddress{"/dev/gpiochip0", 65535});
  for (const char* name : {"", ":", "GPIO25", "gpiochip0", "gpiochip0:", "gpiochip0:-1", "gpiochip0:65536",
                           "gpiochip0:99999999999", "gpiochip0:1x", "gpiochip0: 1", "chip:1", "PIN:3",
                           "gpiochip0/../null:1", "/dev/spidev0.0:1"}) {
    CAPTURE(name);
    CHECK_FALSE(parse_line_address(name).has_value());
  }
  LineAddress found;
  CHECK(ok(gpio::find_line_address("gpiochip0:25", found)));
  CHECK(found == LineAddress{"/dev/gpiochip0", 25});
  CHECK(gpio::find_line_address("", found).status == Status::kInvalidArgument);
}

TEST_CASE("a descriptor is closed once, and its number may then be another's") {
  FileDescriptor file = FileDescriptor::open_device("/dev/null");
  REQUIRE(file.is_open());
  file.close();
  CHECK_FALSE(file.is_open());
}

TEST_CASE("devices that are none are refused, and stay closed") {
  const std::uint8_t byte = 0;
  SpiDevice spi;
  CHECK(spi.open("/dev/null", {}).status == Status::kUnsupported);
  CHECK(spi.open("/nowhere", {}).text() == "cannot be opened: No such file or directory");
  CHECK(spi.write({&byte, 1}) == Status::kNotReady);
  I2cDevice i2c;
  CHECK(i2c.open("/dev/null").status == Status::kUnsupported);
  CHECK(i2c.open("/nowhere").status == Status::kNotReady);
  CHECK(i2c.write(0x3C, {&byte, 1}) == Status::kNotReady);
  FramebufferDevice framebuffer;
  CHECK(framebuffer.open("/dev/null").status == Status::kUnsupported);
  CHECK(framebuffer.open("/nowhere").status == Status::kNotReady);
  CHECK(framebuffer.width() == 0);
  CHECK(ok(framebuffer.restore()));
  GpioPin pin;
  CHECK_FALSE(ok(pin.request("gpiochip4711:0", hal::Level::kLow)));
  CHECK_FALSE(pin.is_held());
}

namespace {

void ignore_alarm(int) {}

// A timer whose signals cut every wait into pieces of a millisecond.
class Interruptions {
 public:
  Interruptions() {
    struct sigaction action {};
    action.sa_handler = &ignore_alarm;
    ::sigaction(SIGALRM, &action, &before_);
    const itimerval every{{0, 1000}, {0, 1000}};
    ::setitimer(ITIMER_REAL, &every, nullptr);
  }
  ~Interruptions() {
    const itimerval never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
    ::sigaction(SIGALRM, &before_, nullptr);
  }
  Interruptions(const Interruptions&) = delete;
  Interruptions& operator=(const Interruptions&) = delete;

 private:
  struct sigaction before_ {};
};

timespec in_milliseconds(long ms) {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  time.tv_nsec += ms * 1'000'000;
  time.tv_sec += time.tv_nsec / 1'000'000'000;
  time.tv_nsec %= 1'000'000'000;
  return time;
}

}  // namespace

TEST_CASE("a delay is never shorter than asked, signals or not") {
  MonotonicClock clock;
  for (const bool interrupted : {false, true}) {
    std::optional<Interruptions> interruptions;
    if (interrupted) interruptions.emplace();
    for (const std::uint32_t us : {1U, 50U, 999U, 20'000U}) {
      const std::uint32_t begin = clock.now_us();
      clock.delay_us(us);
      CHECK(clock.now_us() - begin >= us);
    }
  }
}

TEST_CASE("signals wait until they are looked for, and act as before afterwards") {
  // Background jobs of a shell ignore these signals, and waiting for an ignored one never ends.
  for (const int signal : {SIGINT, SIGQUIT, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
  {
    const Interruptions interruptions;
    SignalWatch signals;
    CHECK(signals.poll() == 0);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGUSR1, SIGUSR2, SIGVTALRM,
                             SIGPROF, SIGXFSZ, SIGPOLL, SIGPWR, SIGRTMIN, SIGRTMAX}) {
      std::raise(signal);
      CHECK(signals.poll() == signal);
      CHECK(signals.poll() == 0);
      std::raise(signal);
      CHECK(signals.wait() == signal);
    }
    MonotonicClock clock;
    const std::uint32_t begin = clock.now_us();
    CHECK(signals.wait_until(in_milliseconds(20)) == 0);
    CHECK(clock.now_us() - begin >= 19'000);
    std::raise(SIGTERM);
    CHECK(signals.wait_until(in_milliseconds(100'000)) == SIGTERM);
  }
  sigset_t blocked;
  ::pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  CHECK(sigismember(&blocked, SIGTERM) == 0);
}

TEST_CASE("an alarm that nobody handles waits, too") {
  SignalWatch signals;
  std::raise(SIGALRM);
  CHECK(signals.wait_until(in_milliseconds(100'000)) == SIGALRM);
}

TEST_CASE("a signal that was ignored stays ignored") {
  struct sigaction ignore {};
  struct sigaction before {};
  ignore.sa_handler = SIG_IGN;
  ::sigaction(SIGHUP, &ignore, &before);
  {
    SignalWatch signals;
    std::raise(SIGHUP);
    CHECK(signals.poll() == 0);
  }
  ::sigaction(SIGHUP, &before, nullptr);
}
