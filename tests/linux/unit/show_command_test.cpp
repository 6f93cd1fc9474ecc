// SPDX-License-Identifier: MIT
// What of `arcspan show` needs no display; the rest is in guest/scenarios/show.
#ifdef ARCSPAN_COMMAND

#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>

using namespace arcspan::test;

TEST_CASE("show names a mistake in one line") {
  const struct {
    const char* arguments;
    int status;
    const char* message;
  } cases[] = {
      {"", 2, "arcspan: MESH is required\n"},
      {"sphere:8x4", 2, "arcspan: --device is required\n"},
      {"sphere:8x4 --device /dev/fb0 --fps nan", 2,
       "arcspan: --fps: expected a number 0.1...1000, not 'nan'\n"},
      {"sphere:8x4 --device ili9341 --spi-mhz 0", 2,
       "arcspan: --spi-mhz: expected a number 0.1...200, not '0'\n"},
      {"sphere:8x4 --device ili9341 --rotate 45", 2,
       "arcspan: --rotate: expected 0, 90, 180 or 270, not '45'\n"},
      {"sphere:8x4 --device ili9340", 2,
       "arcspan: --device: expected /dev/..., ili9341, st7789, ssd1351, ssd1306, ssd1306-72x40, ssd0323, not "
       "'ili9340'\n"},
      {"sphere:8x4 --device ssd1351 --i2c /dev/i2c-1", 2, "arcspan: --i2c: ssd1351 is on SPI only\n"},
      {"sphere:8x4 --device ssd1306 --i2c /dev/i2c-1 --dc X", 2, "arcspan: --i2c excludes --dc\n"},
      {"sphere:8x4 --device ssd1306 --i2c /dev/i2c-1 --i2c-address 0x78", 2,
       "arcspan: --i2c-address: Value 0x78 not in range 8 to 119\n"},
      {"sphere:8x4 --device ssd1306 --i2c /dev/null", 1,
       "arcspan: /dev/null: is not an I2C adapter: Inappropriate ioctl for device\n"},
      {"sphere:8x4 --device ssd1306 --i2c /dev/i2c-1 --spi-mode 3", 2,
       "arcspan: --i2c excludes --spi-mode\n"},
      {"sphere:8x4 --device ssd1306 --glass 200x64", 2,
       "arcspan: --glass: 200x64 at 0,0 does not fit the 128x64 pixels of ssd1306\n"},
      {"sphere:8x4 --device ili9341", 2, "arcspan: --dc: the panel's D/C line has to be given\n"},
      {"sphere:8x4 --device ili9341 --dc X --spi /dev/null", 1,
       "arcspan: /dev/null: is not an SPI device: Inappropriate ioctl for device\n"},
      {"sphere:8x4 --device /dev/fb0 --turntable 1.5", 2,
       "arcspan: --turntable: Value 1.5 not in range 0 to 3600\n"},
      {"sphere:8x4 --device /dev/fb0 --fps 10", 2, "arcspan: --fps: needs --turntable or --clip\n"},
      {"none.obj --device /dev/fb0", 1, "arcspan: none.obj: cannot read (no such file)\n"},
      {"sphere:8x4 --device /dev/fb4711", 1,
       "arcspan: /dev/fb4711: cannot be opened: No such file or directory\n"},
      {"sphere:8x4 --device /dev/null", 1,
       "arcspan: /dev/null: is not a framebuffer: Inappropriate ioctl for device\n"},
  };
  for (const auto& wrong : cases) {
    CAPTURE(wrong.arguments);
    const CommandRun shown = run(std::string("show ") + wrong.arguments);
    CHECK(shown.status == wrong.status);
    CHECK(shown.err == wrong.message);
    CHECK(shown.out.empty());
  }
}

#endif
