// SPDX-License-Identifier: MIT
// Devices of examples/stm32/ring_ltdc.cpp: a picture is never drawn into the frame that is shown.
#include "main.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" void ring_run(void);

namespace {

constexpr int kPictures = 1200;  // of some turns, which begin at different angles
int pictures = 0;
std::uint32_t shown = 0;

[[noreturn]] void leave(const char* message, int status) {
  std::printf("picture %d: %s\n", pictures, message);
  std::exit(status);
}

}  // namespace

extern "C" {

LTDC_HandleTypeDef hltdc;

void SCB_CleanDCache_by_Addr(uint32_t*, int32_t) {}
HAL_StatusTypeDef HAL_LTDC_SetAddress_NoReload(LTDC_HandleTypeDef*, uint32_t address, uint32_t) {
  if (address == shown) leave("was drawn into the frame that is shown", 1);
  shown = address;
  if (++pictures == kPictures) leave("the last one", 0);
  return HAL_OK;
}
HAL_StatusTypeDef HAL_LTDC_Reload(LTDC_HandleTypeDef* ltdc, uint32_t) {
  HAL_LTDC_ReloadEventCallback(ltdc);
  return HAL_OK;
}
void Error_Handler() { leave("ended with an error", 1); }
}

int main() {
  constexpr std::size_t kBytes = 1 << 20;
  void* const sdram = reinterpret_cast<void*>(0xC0000000UL);
  if (::mmap(sdram, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1,
             0) != sdram) {
    leave("there is no memory for it", 1);
  }
  ring_run();
}
