// SPDX-License-Identifier: MIT
// As much of an Arduino core as the sketches need, with the macros of old cores.
#pragma once

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define constrain(amt, low, high) ((amt) < (low) ? (low) : ((amt) > (high) ? (high) : (amt)))
#define radians(deg) ((deg)*0.017453292519943295)
#define degrees(rad) ((rad)*57.29577951308232)
#define sq(x) ((x) * (x))
#define bit(b) (1UL << (b))
#define lowByte(w) ((uint8_t)((w)&0xff))
#define word(...) makeWord(__VA_ARGS__)
#define F(text) (text)
#define PI 3.1415926535897932384626433832795
#define B0 0
#define B1 1
#define A0 14
#define DEFAULT 1
#define EXTERNAL 0

struct SerialPort {
  void begin(unsigned long) {}
  void println(const char* text = "") { puts(text); }
};
extern SerialPort Serial;

unsigned long millis();
long random(long from, long to);
int analogRead(uint8_t pin);

void setup();
void loop();
