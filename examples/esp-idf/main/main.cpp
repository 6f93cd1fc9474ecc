// SPDX-License-Identifier: MIT
// ESP-IDF 5.1 or newer: a copper ring turns on an ST7789 of 240x240 pixels, by esp_lcd. Two bands of 24 rows:
// one is sent by DMA, and its callback gives a semaphore, while the other is drawn. Change the pins and the
// model.
#include "model.h"

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/pixel/rgb565_swapped.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <driver/gpio.h>
#include <driver/spi_master.h>
#include <esp_err.h>
#include <esp_lcd_panel_io.h>
#include <esp_lcd_panel_ops.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_log.h>
#include <freertos/FreeRTOS.h>
#include <freertos/semphr.h>

using namespace arcspan;
using Band = hal::Framebuffer<Rgb565Swapped>;  // the order of bytes on the wire
using Method = Arc<Illumination<1, Highlight::kPhong>>;

constexpr int kSclk = 18, kMosi = 19, kCs = 5, kDc = 16, kReset = 23;
constexpr std::int32_t kSide = 240, kRows = 24;

constexpr MeshView kMesh = MeshView::of(model::kPositions, model::kNormals, model::kIndices)
                               .with(model::kPlanes, model::kPlaneScale);
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 130, 70}), {kSun});
constexpr Camera kCamera =
    Camera::of({WorldPoint::of(0, 0.5, 3), {}},
               Lens::field_of_view(Turn{8000}, WorldLength::of(1), WorldLength::of(5)), {kSide, kSide});

std::uint16_t pixels[2][kSide * kRows];  // internal RAM, which DMA reaches
std::uint16_t depths[kSide * kRows];
SceneMemory<MethodList<Method>, 1, kMesh.vertex_count(), kMesh.triangle_count()> scene_memory;
SemaphoreHandle_t sent;

bool on_sent(esp_lcd_panel_io_handle_t, esp_lcd_panel_io_event_data_t*, void*) {
  BaseType_t woken = pdFALSE;
  xSemaphoreGiveFromISR(sent, &woken);
  return woken == pdTRUE;
}

esp_lcd_panel_handle_t start_panel() {
  spi_bus_config_t bus = {};
  bus.sclk_io_num = kSclk;
  bus.mosi_io_num = kMosi;
  bus.miso_io_num = bus.quadwp_io_num = bus.quadhd_io_num = -1;
  bus.max_transfer_sz = sizeof pixels[0];
  ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
  esp_lcd_panel_io_spi_config_t wires = {};
  wires.cs_gpio_num = static_cast<gpio_num_t>(kCs);
  wires.dc_gpio_num = static_cast<gpio_num_t>(kDc);
  wires.pclk_hz = 40'000'000;  // an ST7789V is specified for 15 MHz, an ST7789VW for 62.5
  wires.trans_queue_depth = 2;
  wires.on_color_trans_done = on_sent;
  wires.lcd_cmd_bits = wires.lcd_param_bits = 8;
  esp_lcd_panel_io_handle_t io = nullptr;
  ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &wires, &io));
  esp_lcd_panel_dev_config_t device = {};
  device.reset_gpio_num = static_cast<gpio_num_t>(kReset);
  device.rgb_ele_order = LCD_RGB_ELEMENT_ORDER_RGB;
  device.bits_per_pixel = 16;
  esp_lcd_panel_handle_t panel = nullptr;
  ESP_ERROR_CHECK(esp_lcd_new_panel_st7789(io, &device, &panel));
  ESP_ERROR_CHECK(esp_lcd_panel_reset(panel));
  ESP_ERROR_CHECK(esp_lcd_panel_init(panel));
  ESP_ERROR_CHECK(esp_lcd_panel_invert_color(panel, true));
  ESP_ERROR_CHECK(esp_lcd_panel_disp_on_off(panel, true));
  return panel;
}

Status show(esp_lcd_panel_handle_t panel, const Object& ring) {
  Status status = prepare_scene({kCamera, {kSun}, {&ring, 1}}, scene_memory);
  bool is_sending = false;
  for (std::int32_t top = 0; top < kSide && ok(status); top += kRows) {
    std::uint16_t* const memory = pixels[top / kRows % 2];
    Band band({memory, kSide * kRows}, kSide, kRows, top);
    DepthBuffer depth(depths, kSide, kRows, top);
    status = draw_prepared_scene(scene_memory, band, depth, {0, 0, 40}).status;
    if (is_sending) xSemaphoreTake(sent, portMAX_DELAY);  // the other band, which is drawn into next
    is_sending = ok(status) && esp_lcd_panel_draw_bitmap(panel, 0, top, kSide, top + kRows, memory) == ESP_OK;
  }
  if (is_sending) xSemaphoreTake(sent, portMAX_DELAY);
  return status;
}

extern "C" void app_main() {
  sent = xSemaphoreCreateCounting(2, 0);
  esp_lcd_panel_handle_t panel = start_panel();
  Object ring(kMesh, kCopper);
  for (std::uint16_t turn = 0;; turn += 400) {
    ring.rotation = rotation_of(EulerAngles{{turn}, {11000}, {}});
    const Status status = show(panel, ring);
    if (!ok(status)) ESP_LOGE("arcspan", "%s", to_string(status));
  }
}
