// SPDX-License-Identifier: MIT
// Arbitrary bytes as a font file of any kind, and what is made of it. The first byte chooses bits and scale.
// A Failure is a right answer; a crash, a sanitizer's report or tables that are no font are not.
#include <arcspan_tools/font/make_font.hpp>
#include <arcspan_tools/font/source_font.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

using namespace arcspan::tools;

namespace {

template <unsigned Bits>
void check(const MadeFont& made) {
  arcspan::overlay::Font<Bits> font;
  if (!ok(arcspan::overlay::Font<Bits>::make(made.ranges, made.glyphs, made.bitmaps, made.line_height, font)))
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  FontOptions options;
  options.ranges = {{0, 0x3FF}, {0xFFFD, 0xFFFD}};
  if ((data[0] & 1u) != 0) options.bits = 4;
  const auto factor = static_cast<std::int32_t>(1 + (data[0] >> 2 & 7u));
  options.scale = (data[0] & 3u) != 0 ? FontScale{1, factor} : FontScale{factor, 1};
  try {
    const MadeFont made = make_font(decode_font(bytes, "fuzz"), options, "fuzz");
    options.bits == 4 ? check<4>(made) : check<1>(made);
  } catch (const Failure&) {
  }
  return 0;
}
