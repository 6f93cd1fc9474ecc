// SPDX-License-Identifier: MIT
// As much of an Arduino core as the example needs; prints on standard output where there is one.
#pragma once

#include <stdint.h>
#include <stdio.h>

struct SerialPort {
  void begin(unsigned long) {}
  void print(char c) { putchar(c); }
  void println(const char* text = "") { puts(text); }
};
inline SerialPort Serial;

void setup();
void loop();
