/* SPDX-License-Identifier: MIT */
/* The C interface of arcspan. It holds Arc, one light and ARCSPAN_RGB565_SWAPPED, no textures. */
#ifndef ARCSPAN_C_H
#define ARCSPAN_C_H

#include "arcspan_c/arcspan.h"

#endif
