// SPDX-License-Identifier: MIT
// All sketches in one source, each in a namespace of its own, so that one run of a compiler checks them.
#include <Adafruit_ILI9341.h>
#include <Arduino.h>
#include <Arduino_GFX_Library.h>
#include <LGFX_AUTODETECT.hpp>
#include <LovyanGFX.hpp>
#include <TFT_eSPI.h>
#include <arcspan.h>

namespace turning_model {
#include "TurningModel/TurningModel.ino"
}
#undef MESH
#undef MATERIAL
namespace animated_eye {
#include "AnimatedEye/AnimatedEye.ino"
}
#undef MESH
#undef MATERIAL
namespace attitude_indicator {
#include "AttitudeIndicator/AttitudeIndicator.ino"
}
namespace gauge {
#include "Gauge/Gauge.ino"
}
