// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/netpbm.hpp>
#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

constexpr std::int64_t kMostValue = 65535;

std::string header(const char* kind, const Image& image) {
  return std::string(kind) + "\n" + std::to_string(image.width) + " " + std::to_string(image.height) +
         "\n255\n";
}

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The numbers of a header, and the samples after it.
class NetpbmReader {
 public:
  NetpbmReader(std::string_view bytes, const std::string& subject)
      : whole_(bytes.size()), rest_(bytes.substr(2)), subject_(subject) {}

  /// The next number of the header, which comments may precede.
  std::int64_t number(const char* what, std::int64_t most) {
    skip_blanks();
    std::int64_t value = 0;
    std::size_t digits = 0;
    for (; digits < rest_.size() && is_digit(rest_[digits]); ++digits) {
      value = value <= most ? 10 * value + (rest_[digits] - '0') : value;
    }
    if (digits == 0) fail(std::string(what) + " is not a number");
    const std::string text(rest_.substr(0, std::min<std::size_t>(digits, 12)));
    rest_.remove_prefix(digits);
    if (value < 1 || value > most) {
      fail(std::string(what) + " " + text + " out of range 1 to " + std::to_string(most));
    }
    return value;
  }

  /// A single blank separates the header from the samples, of which so many bytes must follow.
  void begin_samples(std::uint64_t bytes) {
    if (rest_.empty() || !is_blank(rest_[0])) fail("its header has no end");
    rest_.remove_prefix(1);
    if (rest_.size() >= bytes) return;
    throw Failure(subject_, "truncated (" + std::to_string(whole_) + " bytes of " +
                                std::to_string(whole_ - rest_.size() + bytes) + ")");
  }

  /// The next sample, of one byte or two, scaled to 255.
  std::uint8_t sample(std::int64_t maximum) {
    std::int64_t value = byte();
    if (maximum > 255) value = 256 * value + byte();
    if (value > maximum) {
      fail("value " + std::to_string(value) + " above the largest, " + std::to_string(maximum));
    }
    return static_cast<std::uint8_t>((255 * value + maximum / 2) / maximum);
  }

 private:
  void skip_blanks() {
    bool comment = false;
    std::size_t at = 0;
    for (; at < rest_.size() && (comment || is_blank(rest_[at]) || rest_[at] == '#'); ++at) {
      if (rest_[at] == '#') comment = true;
      if (rest_[at] == '\n' || rest_[at] == '\r') comment = false;
    }
    rest_.remove_prefix(at);
  }

  std::int64_t byte() {
    const auto value = static_cast<unsigned char>(rest_[0]);
    rest_.remove_prefix(1);
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(subject_, "a damaged PPM or PGM picture (" + what + ")");
  }

  std::size_t whole_;
  std::string_view rest_;
  std::string subject_;
};

}  // namespace

std::string ppm(const Image& image) {
  std::string out = header("P6", image);
  for (const Rgb8& p : image.pixels) {
    for (const std::uint8_t channel : {p.r, p.g, p.b}) out.push_back(static_cast<char>(channel));
  }
  return out;
}

std::string pgm(const Image& image) {
  std::string out = header("P5", image);
  for (const Rgb8& p : image.pixels) out.push_back(static_cast<char>(luma(p)));
  return out;
}

bool is_netpbm(std::string_view bytes) {
  return (bytes.starts_with("P5") || bytes.starts_with("P6")) && bytes.size() > 2 &&
         (is_blank(bytes[2]) || bytes[2] == '#');
}

Image read_netpbm(std::string_view bytes, const std::string& subject) {
  const bool grey = bytes[1] == '5';
  NetpbmReader reader(bytes, subject);
  const std::int64_t width = reader.number("width", kMostPictureSide);
  const std::int64_t height = reader.number("height", kMostPictureSide);
  check_picture_size({grey ? "PGM" : "PPM", width, height}, subject);
  const std::int64_t maximum = reader.number("largest value", kMostValue);
  reader.begin_samples(static_cast<std::uint64_t>(width * height * (grey ? 1 : 3) * (maximum > 255 ? 2 : 1)));
  Image image(static_cast<std::int32_t>(width), static_cast<std::int32_t>(height));
  for (Rgb8& pixel : image.pixels) {
    pixel.r = reader.sample(maximum);
    pixel.g = grey ? pixel.r : reader.sample(maximum);
    pixel.b = grey ? pixel.r : reader.sample(maximum);
  }
  return image;
}

}  // namespace arcspan::tools
