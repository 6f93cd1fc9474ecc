// SPDX-License-Identifier: MIT
#pragma once
#include "LovyanGFX.hpp"

class LGFX : public LGFX_Device {};
