// SPDX-License-Identifier: MIT
// The signatures of TFT_eSPI 2.5 that send_band() uses.
#pragma once
#include "display_model.h"

class TFT_eSPI {
 public:
  void init(uint8_t = 0) {}
  bool initDMA(bool = false) { return true; }
  void startWrite() { model_.begin_transaction(); }
  void endWrite() { model_.end_transaction(); }
  void dmaWait() { model_.wait(); }
  void pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t* data, uint16_t* = nullptr) {
    model_.send(x, y, w, h, data);
  }
  void pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t const* data) {
    model_.send(x, y, w, h, data);
  }

 private:
  DisplayModel model_;
};
