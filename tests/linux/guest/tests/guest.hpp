// SPDX-License-Identifier: MIT
// The test's side of guest/module and of gpio-sim.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace arcspan::test {

inline std::string environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) throw std::runtime_error(std::string(name) + " is not set: this runs in the guest");
  return value;
}

inline std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path);
  out << text << std::flush;
  if (!out) throw std::runtime_error("cannot write " + path);
}

/// The models of the buses: their logs and their faults.
class BusModels {
 public:
  BusModels() { set("clear", 1); }
  ~BusModels() { set("clear", 1); }
  BusModels(const BusModels&) = delete;
  BusModels& operator=(const BusModels&) = delete;

  /// Each byte with the level of D/C as bit 8.
  [[nodiscard]] std::vector<std::uint16_t> spi() const { return words("spi_log"); }
  [[nodiscard]] std::vector<std::uint16_t> i2c() const { return words("i2c_log"); }
  void fail_spi_at(unsigned byte) { set("spi_fail_at", byte); }
  void cut_spi_at(unsigned byte) { set("spi_short_at", byte); }
  void i2c_error(unsigned error) { set("i2c_error", error); }

 private:
  static constexpr const char* kFolder = "/sys/kernel/debug/arcspan/";

  static void set(const char* file, unsigned value) {
    write_text(std::string(kFolder) + file, std::to_string(value));
  }
  static std::vector<std::uint16_t> words(const char* file) {
    const std::string bytes = read_text(std::string(kFolder) + file);
    std::vector<std::uint16_t> result(bytes.size() / 2);
    std::memcpy(result.data(), bytes.data(), result.size() * 2);
    return result;
  }
};

/// The level of line `offset` of the simulated chip as the kernel has it: '0' or '1'.
inline char line_level(unsigned offset) {
  return read_text(environment("GUEST_LINES") + "/sim_gpio" + std::to_string(offset) + "/value").at(0);
}

/// Lets line `offset` of the simulated chip, an input, be pulled up or down from outside.
inline void pull_line(unsigned offset, bool up) {
  write_text(environment("GUEST_LINES") + "/sim_gpio" + std::to_string(offset) + "/pull",
             up ? "pull-up" : "pull-down");
}

}  // namespace arcspan::test
