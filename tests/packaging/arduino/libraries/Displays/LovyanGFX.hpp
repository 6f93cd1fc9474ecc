// SPDX-License-Identifier: MIT
// The signatures of LovyanGFX 1.2 that send_band() uses.
#pragma once
#include "display_model.h"

class LGFX_Device {
 public:
  bool init() { return true; }
  void startWrite(bool = true) { model_.begin_transaction(); }
  void endWrite() { model_.end_transaction(); }
  void waitDMA() { model_.wait(); }
  template <typename T>
  void pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, const T* data) {
    model_.send(x, y, w, h, data);
  }
  void writePixels(const uint16_t*, int32_t, bool) {}

 private:
  DisplayModel model_;
};
