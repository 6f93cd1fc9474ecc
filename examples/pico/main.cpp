// SPDX-License-Identifier: MIT
// Pico SDK, RP2040 or RP2350: a copper ring turns on an ST7789 of 240x240 pixels. Each band of 24 rows is
// drawn by both cores, 12 rows each, while DMA sends the one before it. Change the pins, the glass and the
// model.
#include "model.h"

#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <hardware/dma.h>
#include <hardware/gpio.h>
#include <hardware/spi.h>
#include <pico/multicore.h>
#include <pico/stdlib.h>

using namespace arcspan;
using Pages = hal::PageMode<hal::St7789>;
using Method = Arc<Illumination<1, Highlight::kPhong>>;

constexpr uint kSck = 18, kMosi = 19, kCs = 17, kDc = 20, kReset = 21;
constexpr hal::Glass kGlass{240, 240, 0, 0, false, false, false, true};
constexpr std::int32_t kSide = 240, kRows = 24;  // rows of a band: even, so that each core has half of them

constexpr MeshView kMesh = MeshView::of(model::kPositions, model::kNormals, model::kIndices)
                               .with(model::kPlanes, model::kPlaneScale);
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 130, 70}), {kSun});
constexpr Camera kCamera =
    Camera::of({WorldPoint::of(0, 0.5, 3), {}},
               Lens::field_of_view(Turn{8000}, WorldLength::of(1), WorldLength::of(5)), {kSide, kSide});

class Spi final : public hal::SpiBus {
 public:
  void start() {
    spi_init(spi0, 62'500'000);  // as an ST7789VW is specified; an ST7789V for 15 MHz
    spi_set_format(spi0, 8, SPI_CPOL_0, SPI_CPHA_0, SPI_MSB_FIRST);
    gpio_set_function(kSck, GPIO_FUNC_SPI);
    gpio_set_function(kMosi, GPIO_FUNC_SPI);
    gpio_init(kCs);
    gpio_set_dir(kCs, GPIO_OUT);
    gpio_put(kCs, false);  // the panel is the only device
    channel_ = static_cast<uint>(dma_claim_unused_channel(true));
  }

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override {
    const int sent = spi_write_blocking(spi0, bytes.data(), bytes.size());
    return sent == static_cast<int>(bytes.size()) ? Status::kOk : Status::kTransferShort;
  }
  Status do_start(std::span<const std::uint8_t> bytes) override {
    dma_channel_config config = dma_channel_get_default_config(channel_);
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(spi0, true));
    dma_channel_configure(channel_, &config, &spi_get_hw(spi0)->dr, bytes.data(), bytes.size(), true);
    return Status::kOk;
  }
  // The last bytes are still in the FIFO of the SPI when DMA has ended.
  Status do_poll() override {
    return dma_channel_is_busy(channel_) || spi_is_busy(spi0) ? Status::kBusy : Status::kOk;
  }
  void do_abort() override { dma_channel_abort(channel_); }

  uint channel_ = 0;
};

class Pin final : public hal::OutputPin {
 public:
  explicit Pin(uint number) : number_(number) {}
  void start() {
    gpio_init(number_);
    gpio_set_dir(number_, GPIO_OUT);
  }

 private:
  Status do_set(hal::Level level) override {
    gpio_put(number_, level == hal::Level::kHigh);
    return Status::kOk;
  }
  uint number_;
};

class PicoClock final : public hal::Clock {
  std::uint32_t do_now_us() override { return time_us_32(); }
  void do_delay_us(std::uint32_t us) override { sleep_us(us); }
};

// The memory of one core. Each core prepares the frame itself, in its own memory, and draws its half of a
// band.
struct Core {
  SceneMemory<MethodList<Method>, 1, kMesh.vertex_count(), kMesh.triangle_count()> scene_memory;
  std::uint16_t depths[kSide * kRows / 2];

  Status prepare(const Object& ring) { return prepare_scene({kCamera, {kSun}, {&ring, 1}}, scene_memory); }
  Status draw(Pages::Frame& band, std::int32_t top) {
    Pages::Frame half({band.row(top), Pages::Frame::words(kSide, kRows / 2)}, kSide, kRows / 2, top);
    DepthBuffer depth(depths, kSide, kRows / 2, top);
    return draw_prepared_scene(scene_memory, half, depth, {0, 0, 40}).status;
  }
};

Core cores[2];
Object ring(kMesh, kCopper);
Pages::Frame* shared_band;  // written before core 1 is told to begin
Pages::Frame::Word band_memory[Pages::Frame::words(kSide, kRows)];
std::uint8_t wire_memory[hal::wire_bytes<hal::St7789>(kSide, kRows)];

constexpr std::uint32_t kPrepare = UINT32_MAX;  // otherwise the row at which core 1 begins

void run_core_1() {
  for (;;) {
    const std::uint32_t order = multicore_fifo_pop_blocking();
    const Status status = order == kPrepare ? cores[1].prepare(ring)
                                            : cores[1].draw(*shared_band, static_cast<std::int32_t>(order));
    multicore_fifo_push_blocking(static_cast<std::uint32_t>(status));
  }
}

// Both cores work; returns the first status that is not kOk.
template <class Work>
Status on_both(std::uint32_t order, Work&& work) {
  multicore_fifo_push_blocking(order);
  const Status status = work();
  const auto other = static_cast<Status>(multicore_fifo_pop_blocking());
  return ok(status) ? other : status;
}

int main() {
  Spi bus;
  Pin data_or_command(kDc), reset(kReset);
  PicoClock clock;
  bus.start();
  data_or_command.start();
  reset.start();
  hal::St7789 panel(bus, data_or_command, &reset, clock, kGlass);
  Pages pages(panel, band_memory, wire_memory, kRows);
  Status status = panel.start();
  multicore_launch_core1(run_core_1);
  for (std::uint16_t turn = 0; ok(status); turn += 400) {
    ring.rotation = rotation_of(EulerAngles{{turn}, {11000}, {}});
    status = on_both(kPrepare, [] { return cores[0].prepare(ring); });
    if (!ok(status)) break;
    status = pages.show([](Pages::Frame& band) {
      shared_band = &band;
      const std::int32_t top = band.bounds().top;
      return on_both(static_cast<std::uint32_t>(top + kRows / 2), [&] { return cores[0].draw(band, top); });
    });
  }
  panic("%s", to_string(status));
}
