// SPDX-License-Identifier: MIT
#include "Arduino.h"

SerialPort Serial;

// Time passes and sensors change from call to call, the same in every run.
unsigned long millis() {
  static unsigned long now = 0;
  return now += 700;
}
long random(long from, long to) {
  static uint32_t state = 12345;
  state = state * 1664525u + 1013904223u;
  return from + (long)((state >> 8) % (uint32_t)(to - from));
}
int analogRead(uint8_t) {
  static int value = 300;
  return value = (value + 97) % 1024;
}

#ifdef __arm__
int main() {
  setup();
  for (;;) loop();
}
#endif
