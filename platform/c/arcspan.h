/* SPDX-License-Identifier: MIT */
/* Draws 3D scenes from C99, with integers only and without a heap. All memory comes from the caller.
 *
 * A scene holds lights and objects. A view is a camera with the memory for drawing the scene as it sees it; a
 * scene may have several. A frame is one arcspan_prepare(), then an arcspan_draw() for each band or rectangle
 * of it. Nothing of a scene or view may change from the beginning of arcspan_prepare() to the end of the last
 * arcspan_draw(). docs/c-interface.md has an example; arcspan_config.h chooses what is compiled.
 *
 * The memory of scenes and views, models and binaries must stay where they are as long as they are used.
 * Nothing has to be destroyed. A scene that is made anew in the same memory needs new views. Two views may be
 * drawn by two cores at the same time.
 *
 * World space is right-handed, in any unit. Pictures have x to the right and y down. */
#ifndef ARCSPAN_H
#define ARCSPAN_H

#include <stddef.h>
#include <stdint.h>

#define ARCSPAN_VERSION_MAJOR 0
#define ARCSPAN_VERSION_MINOR 1
#define ARCSPAN_VERSION_PATCH 0
#define ARCSPAN_VERSION_TEXT "0.1.0"
/* A number to compare: 10203 is version 1.2.3. */
#define ARCSPAN_VERSION \
  (ARCSPAN_VERSION_MAJOR * 10000L + ARCSPAN_VERSION_MINOR * 100L + ARCSPAN_VERSION_PATCH)

#ifdef __cplusplus
#define ARCSPAN_CAST(type, number) static_cast<type>(number)
extern "C" {
#else
#define ARCSPAN_CAST(type, number) ((type)(number))
#endif

/* The version of the compiled library, "1.2.3": ARCSPAN_VERSION_TEXT, unless this header is another one's. */
const char* arcspan_version(void);

/* The result of a function: ARCSPAN_OK, or why it failed. A call that fails changes nothing, unless it says
 * otherwise. */
typedef uint8_t arcspan_status;
#define ARCSPAN_OK 0
#define ARCSPAN_INVALID_ARGUMENT 1     /* a number is out of range, or no such object in the scene */
#define ARCSPAN_INDEX_OUT_OF_RANGE 2   /* an index of a mesh names no vertex */
#define ARCSPAN_BUFFER_TOO_SMALL 3     /* memory is smaller than asked for, or a scene has no room */
#define ARCSPAN_UNSUPPORTED 4          /* not compiled: see arcspan_config.h; a binary of another version */
#define ARCSPAN_NOT_READY 5            /* no camera, or no frame has been prepared */
#define ARCSPAN_TRUNCATED 10           /* a binary ends too early */
#define ARCSPAN_CORRUPTED 11           /* a binary contradicts its checksum or itself */
#define ARCSPAN_CACHE_TOO_SMALL 13     /* a part has more vertices than the view has room for */
#define ARCSPAN_NEAR_NOT_BEFORE_FAR 14 /* the planes of a lens are not 0 < nearest < farthest */
#define ARCSPAN_NO_VIEW_DIRECTION 15   /* the eye is at its target, or looks along `up` */
#define ARCSPAN_SCALE_OUT_OF_RANGE 16  /* a curve over an outline leaves the 16 bits of positions */
#define ARCSPAN_TOO_MANY_OBJECTS 18    /* more parts are in view than the view has room for */
#define ARCSPAN_LIGHT_CHANGED 20       /* a material in flash is for another light */

/* A short lower-case text for logs, also for numbers that are no status. */
const char* arcspan_status_text(arcspan_status status);

/* The macros make numbers of constants, rounded; with variables they would link floating point. */

/* A length or coordinate in world space: 16 fraction bits, below 32768 in magnitude. */
typedef int32_t arcspan_length;
#define ARCSPAN_LENGTH(number) ARCSPAN_CAST(arcspan_length, (number)*65536.0 + ((number) < 0 ? -0.5 : 0.5))
/* A fraction from 0 to 1: 15 fraction bits, 0...32768. */
typedef uint16_t arcspan_share;
#define ARCSPAN_SHARE(number) ARCSPAN_CAST(arcspan_share, (number)*32768.0 + 0.5)
/* An angle: 65536 per turn. */
typedef uint16_t arcspan_turn;
#define ARCSPAN_DEGREES(number) \
  ARCSPAN_CAST(arcspan_turn, ARCSPAN_CAST(int32_t, (number)*65536.0 / 360 + ((number) < 0 ? -0.5 : 0.5)))

typedef struct {
  arcspan_length x, y, z;
} arcspan_point;
typedef struct {
  arcspan_share r, g, b;
} arcspan_shares;
typedef struct {
  uint8_t r, g, b;
} arcspan_rgb;
/* Pixels with left <= x < right and top <= y < bottom. */
typedef struct {
  int32_t left, top, right, bottom;
} arcspan_rect;

/* Scenes */

typedef struct arcspan_scene arcspan_scene;
typedef struct {
  uint16_t objects; /* parts of all models together */
  /* Different materials of all binaries together, and those that arcspan_set_material() and
   * arcspan_set_opacity() make of them; each takes about 2 KB. */
  uint16_t materials;
} arcspan_scene_limits;

/* The bytes of memory, at any address, that arcspan_scene_make() takes. */
size_t arcspan_scene_bytes(const arcspan_scene_limits* limits);
/* Makes an empty scene in `memory`, with one white light from behind the viewer's left shoulder. Returns
 * ARCSPAN_BUFFER_TOO_SMALL if `bytes` are fewer than arcspan_scene_bytes(). */
arcspan_status arcspan_scene_make(void* memory, size_t bytes, const arcspan_scene_limits* limits,
                                  arcspan_scene** scene);

typedef struct {
  arcspan_point at;    /* directional: towards the light, of any length but 0; point light: its position */
  arcspan_length half; /* directional: 0; point light: the distance at which half of its strength is left */
  arcspan_share strength;
  arcspan_shares colour;
} arcspan_light;

/* Sets all lights, at most ARCSPAN_C_LIGHTS, and the colour of the ambient light. Materials of binaries are
 * prepared again if they depend on what changes: the ambient light and, with ARCSPAN_C_LIGHTS of 1, strength
 * and colour. Materials of models in flash are not. They always have a white ambient light. With
 * ARCSPAN_C_LIGHTS of 1 they are made for a white light of strength 1; with another strength or colour, or
 * without light, arcspan_draw() returns ARCSPAN_LIGHT_CHANGED. Returns
 *
 *   ARCSPAN_INVALID_ARGUMENT   a strength or colour is above 1, a direction is 0, `half` is negative
 *   ARCSPAN_UNSUPPORTED        more lights, a point light or a coloured light than is compiled */
arcspan_status arcspan_set_lights(arcspan_scene* scene, const arcspan_light* lights, size_t count,
                                  arcspan_shares ambient);

typedef uint8_t arcspan_method;
#define ARCSPAN_ARC 0     /* light per pixel */
#define ARCSPAN_GOURAUD 1 /* light per vertex */
#define ARCSPAN_FLAT 2    /* light per triangle */

typedef struct {
  arcspan_shares ambient, diffuse, specular;
  uint16_t shininess; /* 1...256 */
} arcspan_material;

/* How the parts of a binary are drawn. */
typedef struct {
  arcspan_method method;
  uint8_t tolerance; /* of ARCSPAN_ARC, 0...64 steps of 255; usually 1 */
  uint8_t two_sided; /* 1: back faces of all parts are drawn; 0: of the parts that the model marks */
  /* For all parts. NULL: each part keeps its own; a mesh without material is white plastic. */
  const arcspan_material* material;
  uint8_t toon_steps; /* 2...16: cartoon light in so many steps, by ARCSPAN_ARC; 0: gradual light */
} arcspan_look;

/* Names an object of a scene: one or more parts that are moved together. */
typedef uint16_t arcspan_object;

/* Adds the mesh or model in a binary of `arcspan mesh -o NAME.bin`, which is used in place: it must begin at
 * a multiple of 4. All of it is checked. NULL for `look` is ARCSPAN_ARC with tolerance 1; `object` may be
 * NULL. Nothing poses a model that moves: it is drawn as its vertices are stored, which may be another pose
 * than at rest; see arcspan_add_character() and `arcspan mesh --pose rest`. Returns
 *
 *   ARCSPAN_INVALID_ARGUMENT   the address, or a number of `look` is out of range
 *   ARCSPAN_BUFFER_TOO_SMALL   the scene has no room for all parts or materials
 *   ARCSPAN_UNSUPPORTED        the binary has another version; there is no such method; the method, the
 *                              layout of a texture or light in steps is not compiled; a big-endian machine
 *   ARCSPAN_TRUNCATED, ARCSPAN_CORRUPTED, ARCSPAN_INDEX_OUT_OF_RANGE
 *                              the binary is damaged */
arcspan_status arcspan_add_binary(arcspan_scene* scene, const void* binary, size_t bytes,
                                  const arcspan_look* look, arcspan_object* object);

/* A model with prepared materials, all in flash: `arcspan mesh MODEL -o NAME.cpp --c` defines it. Declare it
 * by `extern const arcspan_model NAME;`. `object` may be NULL. Returns ARCSPAN_BUFFER_TOO_SMALL if the scene
 * has no room for all parts, ARCSPAN_UNSUPPORTED if the layout of a texture is not compiled. */
typedef struct arcspan_model arcspan_model;
arcspan_status arcspan_add_model(arcspan_scene* scene, const arcspan_model* model, arcspan_object* object);

/* An object stands in the origin, is not turned and has a scale of 1 when it is added. These functions return
 * ARCSPAN_INVALID_ARGUMENT if `object` does not name an object of the scene, or a scale is out of range. */
arcspan_status arcspan_set_position(arcspan_scene* scene, arcspan_object object, arcspan_point position);
/* The world length of 32768 object units, at least 2^-10; meshes of the tool fill +-32767 units. */
arcspan_status arcspan_set_scale(arcspan_scene* scene, arcspan_object object, arcspan_length scale);
/* Roll about z, then pitch about x, then yaw about y. */
arcspan_status arcspan_set_angles(arcspan_scene* scene, arcspan_object object, arcspan_turn yaw,
                                  arcspan_turn pitch, arcspan_turn roll);
/* w + xi + yj + zk, of any length; 30 fraction bits. */
typedef struct {
  int32_t w, x, y, z;
} arcspan_quaternion;
#define ARCSPAN_NO_ROTATION \
  { INT32_C(1) << 30, 0, 0, 0 }
arcspan_status arcspan_set_quaternion(arcspan_scene* scene, arcspan_object object,
                                      arcspan_quaternion rotation);
/* The rotation by `b`, then by `a`, of unit length, so that products do not drift. */
arcspan_quaternion arcspan_multiply(arcspan_quaternion a, arcspan_quaternion b);
arcspan_status arcspan_set_visible(arcspan_scene* scene, arcspan_object object, int visible);
/* Draws all parts of an object or character by this material, on their textures; NULL: by their own again.
 * A material that was set makes room when no part is drawn by it any more; parts keep their own. Returns
 *
 *   ARCSPAN_INVALID_ARGUMENT   no such object, a coefficient is above 1, or a shininess not 1...256
 *   ARCSPAN_BUFFER_TOO_SMALL   no room for the materials: one for each texture, one- and two-sided
 *   ARCSPAN_UNSUPPORTED        the object is one of arcspan_add_model() */
arcspan_status arcspan_set_material(arcspan_scene* scene, arcspan_object object,
                                    const arcspan_material* material);
/* The opacity of an object or character, whose materials stay: with 1 it hides what is behind it, with 0 it
 * does not show, in steps of 1/32. Translucent objects are drawn after all others, the farthest first. Their
 * outlines and ink stay, and arcspan_pick() finds them; arcspan_set_visible() hides all. Returns the statuses
 * of arcspan_set_material(), ARCSPAN_INVALID_ARGUMENT also if `opacity` is above 1, and ARCSPAN_UNSUPPORTED
 * if opacity is not compiled. */
arcspan_status arcspan_set_opacity(arcspan_scene* scene, arcspan_object object, arcspan_share opacity);

typedef struct {
  arcspan_point least, most;
} arcspan_box;
/* Sets `box` to one along the axes of the world that contains an object, by the spheres around its parts.
 * Returns ARCSPAN_INVALID_ARGUMENT if `object` does not name an object of the scene. */
arcspan_status arcspan_bounds(const arcspan_scene* scene, arcspan_object object, arcspan_box* box);

/* Characters: objects that clips move */

typedef struct arcspan_character arcspan_character;

/* The bytes of memory, at any address, that arcspan_add_character() takes for the model in a binary; 0 if it
 * cannot be read, or without ARCSPAN_C_CHARACTERS. Other settings are not looked at. */
size_t arcspan_character_bytes(const void* binary, size_t bytes);
/* Adds the model in a binary together with what moves it: nodes, skins, morph targets and clips. The memory
 * must stay where it is. The character is at rest. Returns the statuses of arcspan_add_binary(), and also
 *
 *   ARCSPAN_BUFFER_TOO_SMALL   `memory_bytes` are fewer than arcspan_character_bytes()
 *   ARCSPAN_UNSUPPORTED        without ARCSPAN_C_CHARACTERS */
arcspan_status arcspan_add_character(arcspan_scene* scene, const void* binary, size_t bytes,
                                     const arcspan_look* look, void* memory, size_t memory_bytes,
                                     arcspan_character** character);
/* The object, to be moved and turned like every other. */
arcspan_object arcspan_object_of(const arcspan_character* character);

#define ARCSPAN_NONE UINT16_C(65535)
uint16_t arcspan_clip_count(const arcspan_character* character);
/* The first clip of this name, or ARCSPAN_NONE. */
uint16_t arcspan_find_clip(const arcspan_character* character, const char* name);
/* Within the binary; "" if there is no such clip. */
const char* arcspan_clip_name(const arcspan_character* character, uint16_t clip);
/* The length of a clip, 1...2^30 microseconds; 0 if there is no such clip. */
uint32_t arcspan_clip_length(const arcspan_character* character, uint16_t clip);

typedef uint8_t arcspan_at_end;
#define ARCSPAN_STOP 0   /* the last pose of the clip stays; backwards, the first */
#define ARCSPAN_REPEAT 1 /* the clip begins again */
/* Plays a clip from its beginning. What was played before fades to it in `fade` microseconds, while both
 * move; 0: at once. If a fade is under way, its first clip ends at once. Returns ARCSPAN_INVALID_ARGUMENT if
 * there is no such clip, or `at_end` is neither. */
arcspan_status arcspan_play(arcspan_character* character, uint16_t clip, uint32_t fade,
                            arcspan_at_end at_end);
/* The speed of all clips, 16 fraction bits: ARCSPAN_LENGTH(1) is their own, below 0 is backwards. */
void arcspan_set_speed(arcspan_character* character, int32_t speed);
/* Moves the clip, or that which is faded to, to a time in microseconds, which is limited to its length. */
void arcspan_seek(arcspan_character* character, uint32_t time);
/* The time of that clip, and whether it has stopped at its end, as before the first arcspan_play(). */
uint32_t arcspan_clip_time(const arcspan_character* character);
int arcspan_has_ended(const arcspan_character* character);
/* Moves on by so many microseconds and poses the character; with 0 only the latter. */
void arcspan_advance(arcspan_character* character, uint32_t microseconds);

/* The first node (bone) of this name, or ARCSPAN_NONE. */
uint16_t arcspan_find_node(const arcspan_character* character, const char* name);
/* The position in the world, saturated, of a node as the last arcspan_advance() posed it; arcspan_project()
 * then places a label. Returns ARCSPAN_INVALID_ARGUMENT if there is no such node. */
arcspan_status arcspan_node_position(const arcspan_character* character, uint16_t node,
                                     arcspan_point* position);
/* Moves and turns an object to where a node is in the pose: something that the character holds. Its scale
 * stays. Returns ARCSPAN_INVALID_ARGUMENT if the node or the object is not there, or the object is the
 * character's. */
arcspan_status arcspan_attach(const arcspan_character* character, uint16_t node, arcspan_object object);

/* Views */

typedef struct arcspan_view arcspan_view;
typedef struct {
  uint16_t objects; /* parts in view at a time */
  /* At least those of the largest part. If there is room for those of all parts in view, each of them is
   * transformed once per frame, otherwise once per arcspan_draw(). */
  uint32_t vertices;
  /* In bands, a triangle whose rows are kept costs about 40 instructions less in each band that its part
   * reaches. They take 2.1 bytes each, and are kept for all triangles of a part or none. */
  uint32_t triangles;
} arcspan_view_limits;

/* The least limits with which all objects of `scene` can be drawn; with 1 for `keeps_vertices` those with
 * which each vertex is transformed once per frame, and the rows of all triangles are kept. */
arcspan_view_limits arcspan_limits_of(const arcspan_scene* scene, int keeps_vertices);

/* The bytes of memory, at any address, that arcspan_view_make() takes. */
size_t arcspan_view_bytes(const arcspan_view_limits* limits);
/* Makes a view of `scene`. It draws nothing before arcspan_set_camera(). Returns ARCSPAN_BUFFER_TOO_SMALL if
 * `bytes` are fewer than arcspan_view_bytes(). */
arcspan_status arcspan_view_make(void* memory, size_t bytes, const arcspan_view_limits* limits,
                                 arcspan_scene* scene, arcspan_view** view);

typedef struct {
  uint16_t width, height; /* of the picture, 1...2048 pixels */
  arcspan_turn angle;     /* between its upper and lower edge, below half a turn; 0: parallel */
  arcspan_length extent;  /* of a parallel picture: the world length of its height */
  /* Parts nearer than `nearest` or farther than `farthest` are clipped; 0 < nearest < farthest. */
  arcspan_length nearest, farthest;
} arcspan_lens;
/* Sets lens and position. `up` appears upright; {0, 0, 0} is {0, 1, 0}. Returns ARCSPAN_INVALID_ARGUMENT,
 * ARCSPAN_NEAR_NOT_BEFORE_FAR or ARCSPAN_NO_VIEW_DIRECTION. */
arcspan_status arcspan_set_camera(arcspan_view* view, const arcspan_lens* lens, arcspan_point eye,
                                  arcspan_point target, arcspan_point up);

/* What is seen in a pixel. */
typedef struct {
  int found;             /* 0: nothing, and the rest is 0 */
  arcspan_object object; /* of the part */
  uint16_t part;         /* of the object, from 0 */
  uint32_t triangle;     /* of the part's mesh */
} arcspan_picked;
/* Finds what the last frame that was prepared shows in column x and row y of the picture; nothing outside of
 * it, nor on curves and ink beyond the edges of a mesh. Nothing is drawn. Returns the status of the frame. */
arcspan_status arcspan_pick(arcspan_view* view, int32_t x, int32_t y, arcspan_picked* picked);

/* Where a point of the world is in the picture: sixteenths of pixels, from its left and upper edge. */
typedef struct {
  int32_t x, y;   /* 0 if it is nearer than the lens's `nearest` */
  int in_picture; /* 0: nearer than that, or outside of the picture */
} arcspan_screen_point;
arcspan_screen_point arcspan_project(const arcspan_view* view, arcspan_point point);

/* `rotation` after a drag over the picture by `dx` pixels to the right and `dy` downwards, as if the object
 * were a ball that fills it. Before arcspan_set_camera() it does not change. */
arcspan_quaternion arcspan_dragged(const arcspan_view* view, arcspan_quaternion rotation, int32_t dx,
                                   int32_t dy);

/* Prepares a frame. If it returns another status than ARCSPAN_OK, nothing is drawn until the next frame:
 * ARCSPAN_NOT_READY without a camera, ARCSPAN_TOO_MANY_OBJECTS or ARCSPAN_CACHE_TOO_SMALL beyond the limits.
 */
arcspan_status arcspan_prepare(arcspan_view* view);
/* The rectangle of the picture outside of which the frame has no pixel, nor changes one by smooth outlines or
 * ink; empty if there is none. The vertices are transformed for it, and not again for drawing if the view has
 * room for those of all parts in view. */
arcspan_rect arcspan_drawn_rect(arcspan_view* view);

typedef uint8_t arcspan_format;
#define ARCSPAN_RGB565 0
#define ARCSPAN_RGB565_SWAPPED 1
#define ARCSPAN_RGB888 2   /* bytes R, G, B */
#define ARCSPAN_BGR888 3   /* bytes B, G, R */
#define ARCSPAN_XRGB8888 4 /* bytes B, G, R and one that is 0 */
#define ARCSPAN_ARGB8888 \
  5 /* bytes B, G, R and 255, or less where outlines or opacity cover a pixel in part */
#define ARCSPAN_GRAY8 6
#define ARCSPAN_GRAY4 7 /* two pixels per byte, the left one in the upper bits */
#define ARCSPAN_MONO 8  /* eight pixels per byte, the leftmost in the highest bit */

/* A rectangle of the picture in memory. Where pixels share a byte, columns lie in it as in a row that begins
 * with column 0. */
typedef struct {
  void* pixels;   /* its upper left one, or the byte that holds it */
  size_t bytes;   /* of memory from there on */
  int32_t stride; /* bytes from row to row */
  arcspan_format format;
  arcspan_rect held; /* the rectangle, within 0...32767 */
  uint16_t* depth;   /* memory for depths: arcspan_depth_words(held) */
  size_t depth_words;
  const arcspan_rgb* background; /* NULL: pixels that no object covers keep their colour */
} arcspan_target;

/* width * height; 0 for a rectangle that is empty or not within 0...32767. */
size_t arcspan_depth_words(arcspan_rect held);
/* Draws the rectangle of the last frame that was prepared. Returns the status of that frame, or
 *
 *   ARCSPAN_UNSUPPORTED        the format is not compiled
 *   ARCSPAN_INVALID_ARGUMENT   sides, stride or an address of the target is out of range
 *   ARCSPAN_BUFFER_TOO_SMALL   the rectangle does not fit the memory of pixels or depths
 *   ARCSPAN_LIGHT_CHANGED      see arcspan_set_lights(); what was drawn before stays */
arcspan_status arcspan_draw(arcspan_view* view, const arcspan_target* target);

/* Memory for smooth outlines. What does not fit stays as it is without smoothing. */
typedef struct {
  uint32_t triangles; /* of the largest part, at least 1; a byte each */
  uint32_t edges;     /* of all outlines in view; 12 bytes each */
  uint32_t gaps;      /* where outlines pass between two pixels of a target; 16 bytes each. Smoothing takes
                         none with ARCSPAN_C_MARKED_OUTLINES, ink does */
  uint32_t curves; /* that round outlines of untextured parts, of all in view, at most 21845; 36 bytes each.
                      0: outlines stay straight, as without ARCSPAN_C_CURVED_OUTLINES */
} arcspan_outline_limits;
/* The bytes of memory, at any address, that arcspan_smooth_outlines() takes. */
size_t arcspan_outline_bytes(const arcspan_outline_limits* limits);
/* Smooths the outlines of all frames from the next arcspan_prepare() on; NULL for `memory` ends that.
 * The models must be written by `arcspan mesh --outlines`, or --curved-outlines for curves. The outermost
 * pixels of a target are right only at the sides of the picture and of arcspan_drawn_rect(): a rectangle that
 * is shown needs a target that is larger by one pixel on all others.
 *
 * arcspan_draw() then returns, after it has drawn, ARCSPAN_UNSUPPORTED if a part in view has no neighbours or
 * the format is ARCSPAN_MONO without ink, ARCSPAN_BUFFER_TOO_SMALL if a limit was reached, and
 * ARCSPAN_SCALE_OUT_OF_RANGE if an edge stays straight for that.
 *
 * Returns ARCSPAN_UNSUPPORTED without ARCSPAN_C_OUTLINES, ARCSPAN_INVALID_ARGUMENT for 0 triangles, and
 * ARCSPAN_BUFFER_TOO_SMALL if `bytes` are fewer than arcspan_outline_bytes(). */
arcspan_status arcspan_smooth_outlines(arcspan_view* view, void* memory, size_t bytes,
                                       const arcspan_outline_limits* limits);

/* How outlines are inked. */
typedef struct {
  arcspan_rgb colour;
  uint8_t width;   /* of outlines: 1...4 pixels, outside of the surface */
  uint8_t creases; /* 1: creases are inked too, by lines of one pixel */
} arcspan_ink;
/* Draws the outlines as lines of ink, and smooths them, from the next arcspan_prepare() on; smooths only if
 * `ink` is NULL, and after arcspan_smooth_outlines() has ended smoothing. The memory is that of
 * arcspan_smooth_outlines(): ink of creases takes up to twice as many gaps. A target must be larger by two
 * pixels instead of one if creases are inked. ARCSPAN_MONO has ink, without soft edges. Returns
 *
 *   ARCSPAN_NOT_READY          there is ink, but no memory from arcspan_smooth_outlines()
 *   ARCSPAN_INVALID_ARGUMENT   the width is out of range
 *   ARCSPAN_UNSUPPORTED        without ARCSPAN_C_INK */
arcspan_status arcspan_ink_outlines(arcspan_view* view, const arcspan_ink* ink);

#ifdef __cplusplus
}
#endif

#endif
