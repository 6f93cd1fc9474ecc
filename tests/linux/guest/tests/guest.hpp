// SPDX-License-Identifier: MIT
// The test's side of guest/module.
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

/// A file of module/gpio_chips.c.
inline std::string gpio_file(const std::string& name) { return "/sys/kernel/debug/arcspan_gpio/" + name; }

/// The level of line `offset` of the chip GUEST_CHIP, as the chip has it: '0' or '1'.
inline char line_level(unsigned offset) {
  return read_text(gpio_file("line" + std::to_string(offset))).at(0);
}

/// Lets the wire of line `offset` of the chip GUEST_CHIP be pulled up or down from outside.
inline void pull_line(unsigned offset, bool up) {
  write_text(gpio_file("line" + std::to_string(offset)), up ? "1" : "0");
}

}  // namespace arcspan::test
