// SPDX-License-Identifier: MIT
// /dev/fb0 is the kernel's vfb, whose depth can be chosen.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/linux_host/framebuffer/framebuffer_sink.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <tests/linux/guest/tests/guest.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

using namespace arcspan;
using namespace arcspan::linux_host;
using namespace arcspan::test;

namespace {

constexpr const char* kDevice = "/dev/fb0";
constexpr int kWidth = 200;
constexpr int kHeight = 120;

int writes_until_failure = 0;  // the last of them fails; 0: none

/// A second way to the framebuffer, for the test.
class Raw {
 public:
  Raw() : fd_(::open(kDevice, O_RDWR | O_CLOEXEC)) { REQUIRE(fd_ >= 0); }
  ~Raw() { ::close(fd_); }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;

  void set_mode(unsigned bits, unsigned yoffset = 0) {
    fb_var_screeninfo mode = get_mode();
    mode.xres = mode.xres_virtual = kWidth;
    mode.yres = kHeight;
    mode.yres_virtual = 2 * kHeight;
    mode.xoffset = 0;
    mode.yoffset = yoffset;
    mode.bits_per_pixel = bits;
    mode.transp = {};
    mode.activate = FB_ACTIVATE_NOW;
    REQUIRE(::ioctl(fd_, FBIOPUT_VSCREENINFO, &mode) == 0);
    REQUIRE(get_mode().bits_per_pixel == bits);
    REQUIRE(::ioctl(fd_, FBIOPAN_DISPLAY, &mode) == 0);
  }
  [[nodiscard]] fb_var_screeninfo get_mode() const {
    fb_var_screeninfo mode{};
    REQUIRE(::ioctl(fd_, FBIOGET_VSCREENINFO, &mode) == 0);
    return mode;
  }
  [[nodiscard]] std::size_t pitch() const {
    fb_fix_screeninfo fixed{};
    REQUIRE(::ioctl(fd_, FBIOGET_FSCREENINFO, &fixed) == 0);
    return fixed.line_length;
  }
  [[nodiscard]] std::vector<std::uint8_t> memory() const {
    std::vector<std::uint8_t> bytes(pitch() * 2 * kHeight);
    REQUIRE(::pread(fd_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    return bytes;
  }
  void fill() {
    std::vector<std::uint8_t> bytes(pitch() * 2 * kHeight);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 31 + i / 251);
    REQUIRE(::pwrite(fd_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
  }
  [[nodiscard]] std::vector<std::uint16_t> palette() const {
    std::vector<std::uint16_t> levels(3 * 256);
    fb_cmap map{0, 256, levels.data(), levels.data() + 256, levels.data() + 512, nullptr};
    REQUIRE(::ioctl(fd_, FBIOGETCMAP, &map) == 0);
    return levels;
  }

 private:
  int fd_;
};

/// Draws an octahedron in the middle of `sink`.
template <class Sink>
void draw(Sink& sink) {
  constexpr std::int16_t kR = 32000;
  static constexpr ObjectPosition kPositions[] = {{kR, 0, 0},  {-kR, 0, 0}, {0, kR, 0},
                                                  {0, -kR, 0}, {0, 0, kR},  {0, 0, -kR}};
  static constexpr std::uint8_t kIndices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                              2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  PackedNormal normals[6];
  for (int i = 0; i < 6; ++i) normals[i] = pack_normal(kPositions[i].x, kPositions[i].y, kPositions[i].z);
  MeshView mesh;
  REQUIRE(ok(MeshView::make(kPositions, normals, std::span(kIndices), mesh)));
  Placement placement{Rotation::about_x({5000}) * Rotation::about_y({5000}), {}};
  placement.translation[2] = ObjectLength::of(-90000);
  ClipTransform transform;
  REQUIRE(ok(ClipTransform::make(placement,
                                 {PixelLength::of(150), ObjectLength::of(40000), ObjectLength::of(140000)},
                                 {kWidth, kHeight}, transform)));
  Material material;
  material.ambient = {Coefficient::of(0.1), Coefficient::of(0.2), Coefficient::of(0.3)};
  material.diffuse = {Coefficient::of(0.8), Coefficient::of(0.5), Coefficient::of(0.2)};
  material.specular = {Coefficient::of(0.4), Coefficient::of(0.4), Coefficient::of(0.4)};
  using Light = Illumination<1, Highlight::kBlinn>;
  Light light;
  REQUIRE(ok(Light::make(material, {DirectionalLight{placement.rotation.to_object(normalised(-2, 3, 4))}},
                         placement.rotation.to_object(normalised(0, 0, 1)), light)));
  const DrawResult drawn = draw_mesh<Arc<Light>>(mesh, transform, light, sink, NoDepth{});
  REQUIRE(ok(drawn.status));
  REQUIRE(drawn.triangles == 3);
}

// The number of pixels that the kernel's memory holds otherwise than `expected` in format F, encoded.
template <class F>
int differences(const Raw& raw, unsigned yoffset) {
  std::vector<typename F::Word> memory(hal::Framebuffer<F>::words(kWidth, kHeight));
  hal::Framebuffer<F> expected(memory, kWidth, kHeight);
  expected.clear({10, 20, 30});
  draw(expected);
  FramebufferDevice again;
  REQUIRE(ok(again.open(kDevice)));
  const std::vector<std::uint8_t> shown = raw.memory();
  int different = 0;
  for (int y = 0; y < kHeight; ++y) {
    const std::uint8_t* row = shown.data() + raw.pitch() * (static_cast<unsigned>(y) + yoffset);
    for (int x = 0; x < kWidth; ++x) {
      PixelLayout layout = again.layout();
      if (layout.load(row, static_cast<std::size_t>(x)) !=
          layout.decode(layout.encode(expected.pixel(x, y)))) {
        ++different;
      }
    }
  }
  return different;
}

}  // namespace

/// Instead of libc's.
extern "C" ssize_t pwrite(int fd, const void* bytes, std::size_t count, off_t at) {
  if (writes_until_failure > 0 && --writes_until_failure == 0) {
    errno = EIO;
    return -1;
  }
  return ::syscall(SYS_pwrite64, fd, bytes, count, at);
}

TEST_CASE(
    "what the pipeline draws is what the kernel's framebuffer holds, in every depth; then all is as before") {
  Raw raw;
  for (const unsigned yoffset : {0U, 37U}) {
    for (const unsigned bits : {1U, 8U, 16U, 24U, 32U}) {
      CAPTURE(bits, yoffset);
      raw.set_mode(bits, yoffset);
      raw.fill();
      const std::vector<std::uint8_t> memory = raw.memory();
      const std::vector<std::uint16_t> palette = raw.palette();
      {
        FramebufferDevice device;
        REQUIRE(ok(device.open(kDevice)));
        CHECK(device.width() == kWidth);
        CHECK(device.height() == kHeight);
        CHECK(device.layout().bits == bits);
        FramebufferSink sink(device);
        sink.clear({10, 20, 30});
        draw(sink);
        REQUIRE(ok(sink.show()));
        CHECK((raw.memory() != memory));
        const std::string format = device.layout().pipeline_format();
        if (format == "rgb565") CHECK(differences<Rgb565>(raw, yoffset) == 0);
        if (format == "rgb888") CHECK(differences<Rgb888>(raw, yoffset) == 0);
        if (format == "mono") CHECK(differences<Mono>(raw, yoffset) == 0);
        CHECK(format == (bits == 1 ? "mono" : bits == 16 ? "rgb565" : "rgb888"));
        CHECK(sink.pixel(0, 0) == device.layout().decode(device.layout().encode({10, 20, 30})));
        CHECK((raw.palette() != palette) == (bits == 8));
      }
      CHECK((raw.memory() == memory));
      CHECK((raw.palette() == palette));
    }
  }
}

TEST_CASE("rows outside the picture are refused and nothing is written") {
  Raw raw;
  raw.set_mode(16);
  raw.fill();
  FramebufferDevice device;
  REQUIRE(ok(device.open(kDevice)));
  const std::vector<std::uint8_t> memory = raw.memory();
  const std::vector<std::uint8_t> row(device.bytes_per_row(), 1);
  const std::vector<std::uint8_t> part(device.bytes_per_row() - 1, 1);
  CHECK(device.write_rows(-1, row).status == Status::kInvalidArgument);
  CHECK(device.write_rows(kHeight, row).status == Status::kInvalidArgument);
  CHECK(device.write_rows(INT32_MAX, row).status == Status::kInvalidArgument);
  CHECK(device.write_rows(0, part).status == Status::kInvalidArgument);
  CHECK((raw.memory() == memory));
  CHECK(ok(device.write_rows(kHeight - 1, row)));
  CHECK((raw.memory() != memory));
  CHECK(ok(device.restore()));
  CHECK((raw.memory() == memory));
  CHECK(device.write_rows(0, row).status == Status::kNotReady);
  CHECK(ok(device.restore()));
}

TEST_CASE("a row that cannot be restored does not keep the others from it") {
  constexpr int kFailing = 3;
  Raw raw;
  raw.set_mode(16);
  raw.fill();
  FramebufferDevice device;
  REQUIRE(ok(device.open(kDevice)));
  const std::vector<std::uint8_t> before = raw.memory();
  FramebufferSink sink(device);
  sink.clear({10, 20, 30});
  REQUIRE(ok(sink.show()));
  writes_until_failure = kFailing + 1;
  CHECK(device.restore().text() == "pixels cannot be written: Input/output error");
  const std::vector<std::uint8_t> after = raw.memory();
  const std::size_t pitch = raw.pitch();
  for (std::size_t y = 0; y < kHeight; ++y) {
    CAPTURE(y);
    const auto* const row = before.data() + y * pitch;
    CHECK(std::equal(row, row + pitch, after.data() + y * pitch) == (y != kFailing));
  }
}
