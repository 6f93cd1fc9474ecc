// SPDX-License-Identifier: MIT
// What a panel of the MIPI display command set shows after the bytes that it was sent.
//   panel_picture LOG WIDTHxHEIGHT OUT.ppm
// LOG holds 16-bit words, D/C level << 8 | byte. Prints the final state and the address mode, "on awake 48"
// or "off asleep 48"; ends with 1 and a line for a byte that such a panel would not have taken.
#include <arcspan/pixel/rgb565.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using arcspan::Rgb565;

class Panel {
 public:
  Panel(int width, int height)
      : width_(width), height_(height), memory_(static_cast<std::size_t>(width * height), kNoise) {}

  void take(unsigned word) {
    const auto byte = static_cast<std::uint8_t>(word);
    if ((word & 0x100) == 0) {
      begin(byte);
    } else {
      parameter(byte);
    }
  }

  [[nodiscard]] std::string state() const {
    char mode[8];
    std::snprintf(mode, sizeof mode, "%02x", mode_);
    return std::string(on_ ? "on" : "off") + (awake_ ? " awake " : " asleep ") + mode;
  }

  void write(const char* path) const {
    std::ofstream out(path, std::ios::binary);
    out << "P6\n" << width_ << " " << height_ << "\n255\n";
    for (const Rgb565::Encoded code : memory_) {
      const arcspan::Rgb8 c = Rgb565::decode(code);
      out.put(static_cast<char>(c.r)).put(static_cast<char>(c.g)).put(static_cast<char>(c.b));
    }
    if (!out) throw std::runtime_error("the picture cannot be written");
  }

 private:
  static constexpr Rgb565::Encoded kNoise = 0xF81F;

  [[noreturn]] static void refuse(const char* why, unsigned byte) {
    char text[96];
    std::snprintf(text, sizeof text, "%s: %02x", why, byte);
    throw std::runtime_error(text);
  }

  void begin(std::uint8_t opcode) {
    if (!parameters_.empty()) refuse("a command amid the parameters of", opcode_);
    if (!awake_ && opcode != 0x01 && opcode != 0x11) refuse("a command in sleep", opcode);
    opcode_ = opcode;
    if (opcode == 0x01) *this = Panel(width_, height_);
    if (opcode == 0x11) awake_ = true;
    if (opcode == 0x10) awake_ = false;
    if (opcode == 0x28) on_ = false;
    if (opcode == 0x29) on_ = true;
    if (opcode == 0x2C) x_ = left_, y_ = top_;
  }

  void parameter(std::uint8_t byte) {
    parameters_.push_back(byte);
    const std::size_t wanted = opcode_ == 0x2A || opcode_ == 0x2B ? 4 : opcode_ == 0x2C ? 2 : 1;
    if (parameters_.size() < wanted) return;
    complete();
    parameters_.clear();
  }

  [[nodiscard]] int word(std::size_t i) const { return parameters_[i] << 8 | parameters_[i + 1]; }

  void complete() {
    switch (opcode_) {
      case 0x2A:
        left_ = word(0), right_ = word(2);
        if (left_ > right_ || right_ >= width_) refuse("columns outside the panel, last", parameters_[3]);
        return;
      case 0x2B:
        top_ = word(0), bottom_ = word(2);
        if (top_ > bottom_ || bottom_ >= height_) refuse("rows outside the panel, last", parameters_[3]);
        return;
      case 0x2C:
        return pixel(static_cast<Rgb565::Encoded>(word(0)));
      case 0x36:
        mode_ = parameters_[0];
        return;
      case 0x3A:
        if (parameters_[0] != 0x55) refuse("another pixel format", parameters_[0]);
        formatted_ = true;
        return;
      case 0x51:  // brightness
      case 0x53:
        return;
      default:
        refuse("a parameter of a command that has none", opcode_);
    }
  }

  void pixel(Rgb565::Encoded code) {
    if (!formatted_) refuse("a pixel before the format", code);
    if (y_ > bottom_) refuse("more pixels than the window holds", code);
    memory_[static_cast<std::size_t>(y_ * width_ + x_)] = code;
    if (++x_ > right_) x_ = left_, ++y_;
  }

  int width_;
  int height_;
  std::vector<Rgb565::Encoded> memory_;
  std::vector<std::uint8_t> parameters_;
  unsigned opcode_ = 0;
  int left_ = 0, right_ = 0, top_ = 0, bottom_ = -1;
  int x_ = 0, y_ = 0;
  unsigned mode_ = 0;
  bool awake_ = false;
  bool on_ = false;
  bool formatted_ = false;
};

int run(const char* log, const char* size, const char* out) {
  int width = 0;
  int height = 0;
  if (std::sscanf(size, "%dx%d", &width, &height) != 2) throw std::runtime_error("no size");
  std::ifstream in(log, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Panel panel(width, height);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    panel.take(static_cast<unsigned char>(bytes[i]) |
               static_cast<unsigned>(static_cast<unsigned char>(bytes[i + 1])) << 8);
  }
  panel.write(out);
  std::printf("%s\n", panel.state().c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::runtime_error("usage: panel_picture LOG WIDTHxHEIGHT OUT.ppm");
    return run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "panel_picture: %s\n", e.what());
    return 1;
  }
}
