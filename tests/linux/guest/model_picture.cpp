// SPDX-License-Identifier: MIT
// What the glass of a panel shows after the bytes that it was sent, by the model of its controller.
//   model_picture PANEL LOG OUT.ppm
// LOG is spi_log or i2c_log of module/device_models.c. Ends with 1 and a line if the model complains.
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/hal/sim/ssd0323_model.hpp>
#include <arcspan/hal/sim/ssd1306_model.hpp>
#include <arcspan/hal/sim/ssd1351_model.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace arcspan::hal;

std::unique_ptr<sim::DisplayModel> make_device(const std::string& name) {
  if (name == "ili9341") return std::make_unique<sim::DcsModel>(kIli9341Module);
  if (name == "st7789") return std::make_unique<sim::DcsModel>(kSt7789Module);
  if (name == "ssd1351") return std::make_unique<sim::Ssd1351Model>(kSsd1351Module);
  if (name == "ssd1306") return std::make_unique<sim::Ssd1306Model>(kSsd1306Module);
  if (name == "ssd0323") return std::make_unique<sim::Ssd0323Model>(kSsd0323Module);
  throw std::runtime_error("no such panel: " + name);
}

std::vector<unsigned> words_of(const char* path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(std::string("cannot read ") + path);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::vector<unsigned> words;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    words.push_back(static_cast<unsigned char>(bytes[i]) |
                    static_cast<unsigned>(static_cast<unsigned char>(bytes[i + 1])) << 8);
  }
  return words;
}

/// The log has no times: every command has all the time that it may want.
class Wire {
 public:
  explicit Wire(sim::DisplayModel& device) : device_(device) {}
  void take(unsigned byte, bool data) {
    now_ns_ += data ? 1000 : 1'000'000'000;
    device_.receive(static_cast<std::uint8_t>(byte), data ? Level::kHigh : Level::kLow, now_ns_);
  }

 private:
  sim::DisplayModel& device_;
  std::uint64_t now_ns_ = 0;
};

void replay_spi(const std::vector<unsigned>& words, Wire& wire) {
  for (const unsigned word : words) wire.take(word & 0xFF, (word & 0x100) != 0);
}

/// 0x100 | address, the control byte, bytes, 0x200, and so on.
void replay_i2c(const std::vector<unsigned>& words, Wire& wire) {
  unsigned control = 0;
  bool controlled = false;
  for (const unsigned word : words) {
    if (word >= 0x100) {
      if (word != 0x200 && word != (0x100 | SolomonI2c::kUsualAddress))
        throw std::runtime_error("another address");
      controlled = false;
    } else if (!controlled) {
      control = word;
      controlled = true;
      if (control != 0x00 && control != 0x40) throw std::runtime_error("not a control byte");
    } else {
      wire.take(word, control == 0x40);
    }
  }
}

void write(const sim::Picture& picture, const char* path) {
  std::ofstream out(path, std::ios::binary);
  out << "P6\n" << picture.width << " " << picture.height << "\n255\n";
  for (const arcspan::Rgb8& c : picture.pixels) {
    out.put(static_cast<char>(c.r)).put(static_cast<char>(c.g)).put(static_cast<char>(c.b));
  }
  if (!out) throw std::runtime_error("the picture cannot be written");
}

int run(const char* name, const std::string& log, const char* out) {
  const std::unique_ptr<sim::DisplayModel> device = make_device(name);
  Wire wire(*device);
  const std::vector<unsigned> words = words_of(log.c_str());
  if (log.ends_with("i2c_log")) {
    replay_i2c(words, wire);
  } else {
    replay_spi(words, wire);
  }
  write(device->picture(), out);
  if (!device->complaints().empty()) throw std::runtime_error(device->complaints().front());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::runtime_error("usage: model_picture PANEL LOG OUT.ppm");
    return run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "model_picture: %s\n", e.what());
    return 1;
  }
}
