// SPDX-License-Identifier: MIT
// What the displays of the tests have in common. On a PC they hold a picture, and end the program if a sketch
// sends while another transfer is under way, outside of a transaction or of the picture, or changes pixels
// that are being sent.
#pragma once

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

class DisplayModel {
 public:
  static constexpr int kSide = 240;

  void begin_transaction() { require(!is_open_, "a transaction in a transaction"), is_open_ = true; }
  void end_transaction() {
    require(is_open_ && !sent_, "a transaction ends that is not open, or before its pixels are sent"),
        is_open_ = false;
  }
  void send(int x, int y, int width, int height, const uint16_t* pixels) {
    require(is_open_ && !sent_, "pixels are sent without a transaction, or before the last ones are sent");
    require(x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= kSide && y + height <= kSide,
            "pixels outside");
    sent_ = pixels, x_ = x, y_ = y, width_ = width, height_ = height;
    sum_ = sum();
  }
  void wait() {
    if (!sent_) return;
    require(sum() == sum_, "pixels were changed while they were sent");
#ifndef __arm__
    for (int i = 0; i < width_ * height_; ++i)
      picture[(y_ + i / width_) * kSide + x_ + i % width_] = sent_[i];
#endif
    sent_ = nullptr;
  }

#ifndef __arm__
  inline static uint16_t picture[kSide * kSide];
#endif

 private:
  static void require(bool is_true, const char* complaint) {
    if (is_true) return;
    fprintf(stderr, "%s\n", complaint);
    abort();
  }
  uint32_t sum() const {
    uint32_t sum = 2166136261u;
    for (int i = 0; i < width_ * height_; ++i) sum = (sum ^ sent_[i]) * 16777619u;
    return sum;
  }

  const uint16_t* sent_ = nullptr;
  uint32_t sum_ = 0;
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;
  bool is_open_ = false;
};
