// SPDX-License-Identifier: MIT
#include <arcspan/overlay/utf8.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <string>
#include <string_view>
#include <vector>

using namespace arcspan;
using namespace std::string_view_literals;
using overlay::Utf8Text;

namespace {

using Codes = std::vector<std::uint32_t>;

Codes codes_of(Utf8Text text) {
  Codes codes;
  while (!text.empty()) codes.push_back(text.take());
  return codes;
}

constexpr std::uint32_t kBad = 0xFFFD;

std::string encoded(std::uint32_t code) {
  const auto byte = [](std::uint32_t v) { return static_cast<char>(v); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 63))};
  if (code < 0x10000)
    return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 63)), byte(0x80 | (code & 63))};
  return {byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 63)), byte(0x80 | (code >> 6 & 63)),
          byte(0x80 | (code & 63))};
}

}  // namespace

TEST_CASE("UTF-8: every code point comes back, and surrogates do not") {
  bool same = true;
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    const Codes codes = codes_of(encoded(code));
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    same = same && (surrogate ? codes == Codes{kBad, kBad, kBad} : codes.size() == 1 && codes[0] == code);
  }
  CHECK(same);
}

TEST_CASE("UTF-8: what is no code point becomes U+FFFD, one for each maximal part") {
  CHECK(codes_of("a\xC0\xAF\xE0\x80\xBF\xF0\x81\x82\x41"sv) ==  // Unicode 15.0, table 3-8
        Codes{'a', kBad, kBad, kBad, kBad, kBad, kBad, kBad, kBad, 0x41});
  CHECK(codes_of("\xED\xA0\x80\xED\xBF\xBF\xED\xAF\x41"sv) ==  // table 3-9
        Codes{kBad, kBad, kBad, kBad, kBad, kBad, kBad, kBad, 0x41});
  CHECK(codes_of("\xF4\x91\x92\x93\xFF\x41\x80\xBF\x42"sv) ==  // table 3-10
        Codes{kBad, kBad, kBad, kBad, kBad, 0x41, kBad, kBad, 0x42});
  CHECK(codes_of("\xE1\x80\xE2\xF0\x91\x92\xF1\xBF\x41"sv) == Codes{kBad, kBad, kBad, kBad, 0x41});  // 3-11
  CHECK(codes_of("\xE2\x82"sv) == Codes{kBad});  // cut off
  CHECK(codes_of("\xF0\x9F\x98"sv) == Codes{kBad});
  CHECK(codes_of("\xC3"sv) == Codes{kBad});
  CHECK(codes_of("\xC1\xBF\xF5\x80"sv) == Codes{kBad, kBad, kBad, kBad});
}

TEST_CASE("UTF-8: text comes from literals, strings and char8_t, and ends at its size or its zero") {
  CHECK(codes_of("ab") == Codes{'a', 'b'});
  CHECK(codes_of("a\0b") == Codes{'a'});
  CHECK(codes_of("a\0b"sv) == Codes{'a', 0, 'b'});
  CHECK(codes_of(std::string("\xC2\xB0")) == Codes{0xB0});
  CHECK(codes_of(u8"\u00B0\u2192") == Codes{0xB0, 0x2192});
  CHECK(codes_of(static_cast<const char*>(nullptr)).empty());
  CHECK(codes_of({}).empty());
  CHECK(codes_of(std::string_view()).empty());
  static_assert([] {
    Utf8Text text("\xE2\x82\xAC!");
    return text.take() == 0x20AC && text.take() == '!' && text.empty();
  }());
}

TEST_CASE("UTF-8: any bytes end, with a code point for each byte at most") {
  test::Random random(1);
  for (int i = test::share_of(20000); i > 0; --i) {
    std::string bytes;
    for (std::int32_t n = random.integer(0, 12); n > 0; --n)
      bytes += static_cast<char>(random.chance(0.7) ? random.integer(0x80, 0xFF) : random.integer(0, 0x7F));
    const std::vector<char> exact(bytes.begin(), bytes.end());  // so that a sanitizer sees reads behind it
    const Codes codes = codes_of(exact);
    CHECK(codes.size() <= bytes.size());
    std::string again;
    for (const std::uint32_t code : codes) again += encoded(code);
    CHECK(codes_of(again) == codes);
  }
}
