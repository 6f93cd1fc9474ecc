// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/overlay/caption.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/label_font.inc>  // as the command writes it, not as clang-format would

using namespace arcspan;

using MeasuredFrame = hal::Framebuffer<Rgb565>;

Status draw_measured_caption(MeasuredFrame& frame, const Rect& area, overlay::Utf8Text text);
