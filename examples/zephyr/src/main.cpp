// SPDX-License-Identifier: MIT
// Zephyr 4.1 or newer: a copper ring turns on the display that the device tree chooses (zephyr,display), in
// bands of 16 rows.
#include "model.h"

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb565_swapped.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <zephyr/device.h>
#include <zephyr/drivers/display.h>
#include <zephyr/kernel.h>
#include <zephyr/logging/log.h>
#include <zephyr/version.h>

LOG_MODULE_REGISTER(ring);

using namespace arcspan;
using Method = Arc<Illumination<1, Highlight::kPhong>>;

namespace {

constexpr std::int32_t kMostColumns = 480, kRows = 16;
constexpr MeshView kMesh = MeshView::of(model::kPositions, model::kNormals, model::kIndices)
                               .with(model::kPlanes, model::kPlaneScale);
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 130, 70}), {kSun});

// The order of the two bytes of a pixel in memory. Zephyr 4.4 gave the names another meaning, and not every
// driver says what its display wants: exchange the two if the ring is not copper.
#if ZEPHYR_VERSION_CODE >= ZEPHYR_VERSION(4, 4, 0)
constexpr display_pixel_format kLowByteFirst = PIXEL_FORMAT_RGB_565, kHighByteFirst = PIXEL_FORMAT_RGB_565X;
#else
constexpr display_pixel_format kLowByteFirst = PIXEL_FORMAT_BGR_565, kHighByteFirst = PIXEL_FORMAT_RGB_565;
#endif

const device* const display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
std::uint16_t pixels[kMostColumns * kRows];
std::uint16_t depths[kMostColumns * kRows];
SceneMemory<MethodList<Method>, 1, kMesh.vertex_count(), kMesh.triangle_count()> scene_memory;

// display_write() returns when the pixels are sent or copied, so one band is enough.
template <class Format>
int show(std::int32_t width, std::int32_t height) {
  for (std::int32_t top = 0; top < height; top += kRows) {
    hal::Framebuffer<Format> band(pixels, width, kRows, top);
    DepthBuffer depth(depths, width, kRows, top);
    const Status status = draw_prepared_scene(scene_memory, band, depth, {0, 0, 40}).status;
    if (!ok(status)) {
      LOG_ERR("%s", to_string(status));
      return -EINVAL;
    }
    display_buffer_descriptor rows = {};
    rows.width = rows.pitch = static_cast<std::uint16_t>(width);
    rows.height = static_cast<std::uint16_t>(height - top < kRows ? height - top : kRows);
    rows.buf_size = 2u * rows.width * rows.height;
    rows.frame_incomplete =
        top + kRows < height;  // drivers with two frames exchange them after the last band
    const int failed = display_write(display, 0, static_cast<std::uint16_t>(top), &rows, pixels);
    if (failed) return failed;
  }
  return 0;
}

bool is_16_bit(display_pixel_format format) { return format == kLowByteFirst || format == kHighByteFirst; }

}  // namespace

int main() {
  if (!device_is_ready(display)) return -ENODEV;
  display_capabilities has = {};
  display_get_capabilities(display, &has);
  if (!is_16_bit(has.current_pixel_format) && display_set_pixel_format(display, PIXEL_FORMAT_RGB_565) == 0)
    display_get_capabilities(display, &has);  // the window of native_sim begins with 32 bits per pixel
  if (has.x_resolution > kMostColumns || !is_16_bit(has.current_pixel_format)) {
    LOG_ERR("the display has %u columns and pixel format %u", has.x_resolution,
            static_cast<unsigned>(has.current_pixel_format));
    return -ENOTSUP;
  }
  Camera camera;
  Status status = Camera::make({WorldPoint::of(0, 0.5, 3), {}},
                               Lens::field_of_view(Turn{8000}, WorldLength::of(1), WorldLength::of(5)),
                               {has.x_resolution, has.y_resolution}, camera);
  display_blanking_off(display);
  Object ring(kMesh, kCopper);
  int failed = 0;
  for (std::uint16_t turn = 0; ok(status) && failed == 0; turn += 400) {
    ring.rotation = rotation_of(EulerAngles{{turn}, {11000}, {}});
    status = prepare_scene({camera, {kSun}, {&ring, 1}}, scene_memory);
    if (!ok(status)) break;
    failed = has.current_pixel_format == kHighByteFirst
                 ? show<Rgb565Swapped>(has.x_resolution, has.y_resolution)
                 : show<Rgb565>(has.x_resolution, has.y_resolution);
  }
  LOG_ERR("%s, %d", to_string(status), failed);
  return -EIO;
}
