// SPDX-License-Identifier: MIT
// The signatures of Adafruit_GFX 1.11 and Adafruit_ILI9341 that send_band() uses, as in Adafruit_SPITFT.h at
// fe0683af.
#pragma once
#include "display_model.h"

class Adafruit_SPITFT {
 public:
  void startWrite() { model_.begin_transaction(); }
  void endWrite() { model_.end_transaction(); }
  virtual void setAddrWindow(uint16_t x, uint16_t y, uint16_t w, uint16_t h) = 0;
  void writePixels(uint16_t* colors, uint32_t len, bool block = true, bool big_endian = false) {
    if (len != uint32_t(w_) * h_ || !big_endian) abort();
    model_.send(x_, y_, w_, h_, colors);
    if (block) model_.wait();
  }
  void dmaWait() { model_.wait(); }

 protected:
  uint16_t x_ = 0, y_ = 0, w_ = 0, h_ = 0;

 private:
  DisplayModel model_;
};

class Adafruit_ILI9341 : public Adafruit_SPITFT {
 public:
  Adafruit_ILI9341(int8_t, int8_t, int8_t = -1) {}
  void begin(uint32_t = 0) {}
  void setAddrWindow(uint16_t x, uint16_t y, uint16_t w, uint16_t h) override {
    x_ = x, y_ = y, w_ = w, h_ = h;
  }
};
