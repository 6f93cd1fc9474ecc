// SPDX-License-Identifier: MIT
// Runs a sketch on the PC for some frames and writes what its display shows as PPM.
#include <Arduino.h>
#include <display_model.h>

int main(int, char** arguments) {
  setup();
  for (int i = atoi(arguments[1]); i > 0; --i) loop();
  printf("P6\n%d %d\n255\n", DisplayModel::kSide, DisplayModel::kSide);
  for (const uint16_t swapped : DisplayModel::picture) {
    const unsigned pixel = (swapped >> 8 | swapped << 8) & 0xFFFF;
    putchar((pixel >> 11) * 255 / 31), putchar((pixel >> 5 & 63) * 255 / 63),
        putchar((pixel & 31) * 255 / 31);
  }
}
