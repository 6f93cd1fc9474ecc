// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/drm_device.hpp>
#include <arcspan/linux_host/drm/output.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/xrgb8888.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <span>
#include <string>

using namespace arcspan;
using namespace arcspan::linux_host;
using namespace arcspan::linux_host::drm;

namespace {

constexpr std::uint32_t kCrtcs[] = {40, 41, 42};

// "connector crtc" by index, or the refusal.
std::string output_of(std::span<const Connector> connectors) {
  Output output{99, 99};
  const Result result = choose_output(connectors, kCrtcs, output);
  if (!ok(result)) return result.text();
  return std::to_string(output.connector) + " " + std::to_string(output.crtc);
}

std::string stride_of(std::uint32_t bits, std::uint32_t pitch, std::uint64_t size) {
  std::int32_t stride = -1;
  const Result result = find_stride(100, 10, bits, pitch, size, stride);
  return ok(result) ? std::to_string(stride) : result.text();
}

}  // namespace

TEST_CASE("the mode is the first preferred one, or else the first of the largest") {
  CHECK(choose_mode({}) == 0);
  const Mode modes[] = {{800, 600, false}, {1920, 1080, false}, {1280, 720, true}, {640, 480, true}};
  CHECK(choose_mode(modes) == 2);
  CHECK(choose_mode(std::span(modes).first(2)) == 1);
  const Mode equal[] = {{600, 800, false}, {800, 600, false}, {65535, 65535, false}, {65535, 65535, false}};
  CHECK(choose_mode(std::span(equal).first(2)) == 0);
  CHECK(choose_mode(equal) == 2);
}

TEST_CASE("the output is a display that shows a picture, or else one that has a free CRTC") {
  const Connector unplugged{false, 0, 7};
  const Connector dark{true, 0, 7};
  const Connector dark_on_first{true, 0, 1};
  const Connector lit{true, 41, 2};
  const Connector lit_on_first{true, 40, 7};
  const Connector unplugged_but_lit{false, 40, 7};
  CHECK(output_of(std::array{dark, lit}) == "1 1");
  CHECK(output_of(std::array{unplugged_but_lit, lit}) == "1 1");
  CHECK(output_of(std::array{unplugged, dark}) == "1 0");
  CHECK(output_of(std::array{unplugged_but_lit, dark}) == "1 1");
  CHECK(output_of(std::array{dark_on_first, dark}) == "0 0");
  const std::string busy = "no CRTC is free for the connected display";
  CHECK(output_of(std::array{unplugged_but_lit, dark_on_first}) == busy);
  CHECK(output_of(std::array{unplugged_but_lit, dark_on_first, dark}) == "2 1");
  CHECK(output_of(std::array{lit_on_first, dark}) == "0 0");
  CHECK(output_of(std::array{unplugged, unplugged_but_lit}) == "no display is connected");
  CHECK(output_of({}) == "no display is connected");
}

TEST_CASE("rows may be padded, but hold whole pixels in the driver's memory") {
  CHECK(stride_of(32, 400, 4000) == "100");
  CHECK(stride_of(32, 512, 8192) == "128");
  CHECK(stride_of(16, 256, 4096) == "128");
  const std::string pixels = "the rows of the driver's memory do not hold whole pixels";
  CHECK(stride_of(32, 396, 8192) == pixels);
  CHECK(stride_of(32, 510, 8192) == pixels);
  CHECK(stride_of(16, 201, 8192) == pixels);
  const std::string size = "the driver's memory has another size than the picture";
  CHECK(stride_of(32, 400, 3999) == size);
  CHECK(stride_of(32, 0xFFFFFFFC, 0xFFFFFFFF) == size);
  CHECK(stride_of(32, 400, std::uint64_t{4} << 31) == size);
}

TEST_CASE("what is no graphics card is refused, and a closed one has no pixels") {
  CHECK_FALSE(is_drm_device("/dev/null"));
  CHECK_FALSE(is_drm_device("/nowhere"));
  DrmDevice device;
  CHECK_FALSE(ok(device.open("/nowhere")));
  CHECK(device.open("/dev/null").status == Status::kUnsupported);
  CHECK(device.width() == 0);
  CHECK(device.bits() == 0);
  CHECK(device.connector().empty());
  CHECK(device.window<Rgb565>({0, 0, 1, 1}).bounds().empty());
  CHECK(device.window<Xrgb8888>({0, 0, 0, 0}).bounds().empty());
  CHECK(device.show().status == Status::kNotReady);
  CHECK(ok(device.restore()));
}
