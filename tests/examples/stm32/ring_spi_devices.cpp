// SPDX-License-Identifier: MIT
// Devices of examples/stm32/ring_spi.cpp in simulated time, in which drawing takes none: the bus hardly rests
// between two bands.
#include "main.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" void ring_run(void);

namespace {

constexpr std::uint64_t kMillisecond = 1'000'000;  // times are in nanoseconds
constexpr std::uint64_t kByte = 8 * 1000 / 21;     // at 21 MHz
constexpr std::uint64_t kCall = 250;
constexpr std::uint64_t kCyclesPerMillisecond = 168'000;
constexpr int kBands = 30;

std::uint64_t now = 0;
std::uint64_t sent_at = 0;  // when the transfer by DMA ends
std::uint64_t sending = 0;
std::uint64_t idle = 0;
int bands = 0;

void pass(std::uint64_t nanoseconds) {
  now += nanoseconds;
  systick_stub.LOAD = kCyclesPerMillisecond - 1;
  systick_stub.VAL = systick_stub.LOAD - now % kMillisecond * kCyclesPerMillisecond / kMillisecond;
}

}  // namespace

extern "C" {

SysTick_Type systick_stub;
SPI_HandleTypeDef hspi1;
GPIO_TypeDef port_stub;

uint32_t HAL_GetTick() {
  pass(kCall);
  return static_cast<uint32_t>(now / kMillisecond);
}
// HAL_Delay() of stm32f4xx_hal.c waits for one tick more, so that no delay is too short.
void HAL_Delay(uint32_t delay) {
  for (const uint32_t begin = HAL_GetTick(); HAL_GetTick() - begin < delay + 1;) {
  }
}
void HAL_GPIO_WritePin(GPIO_TypeDef*, uint16_t, GPIO_PinState) { pass(kCall); }

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef*, uint8_t*, uint16_t size, uint32_t) {
  pass(kCall + kByte * size);
  return HAL_OK;
}
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef*, uint8_t*, uint16_t size) {
  if (bands > 0) idle += now - sent_at;
  if (bands++ == kBands) return HAL_ERROR;  // ends the example
  sent_at = now + kByte * size;
  sending += kByte * size;
  return HAL_OK;
}
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef*) { return HAL_OK; }
HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef*) {
  pass(kCall);
  return now < sent_at ? HAL_SPI_STATE_BUSY : HAL_SPI_STATE_READY;
}
uint32_t HAL_SPI_GetError(SPI_HandleTypeDef*) { return HAL_SPI_ERROR_NONE; }

void Error_Handler() {
  std::printf("%d bands: %.2f ms of sending, %.2f ms between\n", bands - 1,
              static_cast<double>(sending) / 1e6, static_cast<double>(idle) / 1e6);
  std::exit(bands > kBands && idle * 100 < sending ? 0 : 1);
}
}

int main() { ring_run(); }
