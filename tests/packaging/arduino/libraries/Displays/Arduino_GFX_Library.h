// SPDX-License-Identifier: MIT
// The signatures of Arduino_GFX 1.5 that send_band() uses, as in Arduino_GFX.h at a61dd9f2.
#pragma once
#include "display_model.h"

class Arduino_DataBus {};
class Arduino_HWSPI : public Arduino_DataBus {
 public:
  Arduino_HWSPI(int8_t, int8_t) {}
};
class Arduino_GC9A01 {
 public:
  Arduino_GC9A01(Arduino_DataBus*, int8_t, uint8_t = 0, bool = false) {}
  bool begin(int32_t = 0) { return true; }
  void draw16bitBeRGBBitmap(int16_t x, int16_t y, uint16_t* bitmap, int16_t w, int16_t h) {
    model_.begin_transaction();
    model_.send(x, y, w, h, bitmap);
    model_.wait();
    model_.end_transaction();
  }
  void writePixels(uint16_t*, uint32_t) {}

 private:
  DisplayModel model_;
};
