/* SPDX-License-Identifier: MIT */
/* Chooses the code that is compiled into the C interface (arcspan.h). What is enabled takes flash whether or
 * not it is called. Set these macros by the compiler's command line, by CMake (ARCSPAN_C_OPTIONS) or Kconfig,
 * or in a header of yours that ARCSPAN_CONFIG_FILE names, with its quotes. All sources of a program must see
 * the same values. */
#ifndef ARCSPAN_CONFIG_H
#define ARCSPAN_CONFIG_H

#ifdef ARCSPAN_CONFIG_FILE
#include ARCSPAN_CONFIG_FILE
#endif

/* The most lights of a scene, 1...4. With 1, the light's strength and colour are a part of the materials and
 * the light is directional. With more, lights of all kinds may change from frame to frame, for some
 * instructions per pixel. */
#ifndef ARCSPAN_C_LIGHTS
#define ARCSPAN_C_LIGHTS 1
#endif
#if ARCSPAN_C_LIGHTS < 1 || ARCSPAN_C_LIGHTS > 4
#error "ARCSPAN_C_LIGHTS is not 1...4"
#endif
/* 1 if lights may have colours where ARCSPAN_C_LIGHTS is above 1. With 1 the light always may. */
#ifndef ARCSPAN_C_COLOURED_LIGHTS
#define ARCSPAN_C_COLOURED_LIGHTS 0
#endif
/* The model of highlights: 1 is Phong's (R.V), 0 is Blinn's (N.H). */
#ifndef ARCSPAN_C_PHONG
#define ARCSPAN_C_PHONG 1
#endif

/* 1 if arcspan_look::toon_steps does something. Not with several coloured lights. */
#ifndef ARCSPAN_C_TOON
#define ARCSPAN_C_TOON 0
#endif

/* 1 if arcspan_set_opacity() does something. Every shading method is compiled once more. */
#ifndef ARCSPAN_C_OPACITY
#define ARCSPAN_C_OPACITY 0
#endif

/* Shading methods (arcspan_method). */
#ifndef ARCSPAN_C_ARC
#define ARCSPAN_C_ARC 1
#endif
#ifndef ARCSPAN_C_GOURAUD
#define ARCSPAN_C_GOURAUD 0
#endif
#ifndef ARCSPAN_C_FLAT
#define ARCSPAN_C_FLAT 0
#endif
#if !ARCSPAN_C_ARC && !ARCSPAN_C_GOURAUD && !ARCSPAN_C_FLAT
#error "ARCSPAN_C_ARC, ARCSPAN_C_GOURAUD or ARCSPAN_C_FLAT must be 1"
#endif
/* Layouts of textures; a part with a texture of another is refused. Each compiles every shading method once
 * more, so usually one of them is enabled: arcspan mesh --texture-format makes it. Opaque texels only. */
#ifndef ARCSPAN_C_TEXTURES_RGB565
#define ARCSPAN_C_TEXTURES_RGB565 0
#endif
#ifndef ARCSPAN_C_TEXTURES_PALETTE8
#define ARCSPAN_C_TEXTURES_PALETTE8 0
#endif
#ifndef ARCSPAN_C_TEXTURES_PALETTE4
#define ARCSPAN_C_TEXTURES_PALETTE4 0
#endif

/* 1 if arcspan_smooth_outlines() does something. */
#ifndef ARCSPAN_C_OUTLINES
#define ARCSPAN_C_OUTLINES 0
#endif
/* 1 if it smooths by marks in the depths: it takes no memory for gaps then, and a pixel at which outlines
 * meet may differ from rectangle to rectangle. With ARCSPAN_C_OUTLINES only. */
#ifndef ARCSPAN_C_MARKED_OUTLINES
#define ARCSPAN_C_MARKED_OUTLINES 0
#endif
/* 1 if it rounds them, too, by curves of arcspan_outline_limits. With ARCSPAN_C_OUTLINES only. */
#ifndef ARCSPAN_C_CURVED_OUTLINES
#define ARCSPAN_C_CURVED_OUTLINES 0
#endif
/* 1 if arcspan_ink_outlines() does something; with ARCSPAN_C_OUTLINES only. */
#ifndef ARCSPAN_C_INK
#define ARCSPAN_C_INK 0
#endif
#if ARCSPAN_C_INK && !ARCSPAN_C_OUTLINES
#error "ARCSPAN_C_INK needs ARCSPAN_C_OUTLINES"
#endif
#if ARCSPAN_C_MARKED_OUTLINES && !ARCSPAN_C_OUTLINES
#error "ARCSPAN_C_MARKED_OUTLINES needs ARCSPAN_C_OUTLINES"
#endif
#if ARCSPAN_C_CURVED_OUTLINES && !ARCSPAN_C_OUTLINES
#error "ARCSPAN_C_CURVED_OUTLINES needs ARCSPAN_C_OUTLINES"
#endif

/* 1 if arcspan_add_character() does something. All that draws is compiled once more, for vertices that move.
 */
#ifndef ARCSPAN_C_CHARACTERS
#define ARCSPAN_C_CHARACTERS 0
#endif

/* Pixel formats (arcspan_format). Each holds all the code that draws. */
#ifndef ARCSPAN_C_RGB565
#define ARCSPAN_C_RGB565 1
#endif
#ifndef ARCSPAN_C_RGB565_SWAPPED
#define ARCSPAN_C_RGB565_SWAPPED 0
#endif
#ifndef ARCSPAN_C_RGB888
#define ARCSPAN_C_RGB888 0
#endif
#ifndef ARCSPAN_C_BGR888
#define ARCSPAN_C_BGR888 0
#endif
#ifndef ARCSPAN_C_XRGB8888
#define ARCSPAN_C_XRGB8888 0
#endif
#ifndef ARCSPAN_C_ARGB8888
#define ARCSPAN_C_ARGB8888 0
#endif
#ifndef ARCSPAN_C_GRAY8
#define ARCSPAN_C_GRAY8 0
#endif
#ifndef ARCSPAN_C_GRAY4
#define ARCSPAN_C_GRAY4 0
#endif
#ifndef ARCSPAN_C_MONO
#define ARCSPAN_C_MONO 0
#endif

#endif
