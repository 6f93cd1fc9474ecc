// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

// The shading methods, each once: `entry(name, Class, header)`, where `name` is what people write on a
// command line, `Class` a class template of namespace arcspan and `header` the file that defines it.
// Everything that exists once for each method is made from this list. CMake (tools/shading_methods.cmake) and
// scripts/firmware-costs read it too, so every entry has a line of its own.
// clang-format off

/// The methods that are offered to products.
#define ARCSPAN_FOR_EACH_PRODUCT_METHOD(entry) \
  entry("flat", Flat, "arcspan/shading/flat.hpp") \
  entry("gouraud", Gouraud, "arcspan/shading/gouraud.hpp") \
  entry("arc", Arc, "arcspan/shading/surface/arc.hpp")

/// The methods of the papers, for comparison.
#define ARCSPAN_FOR_EACH_LITERATURE_METHOD(entry) \
  entry("segment", Segment, "arcspan/literature/segment.hpp") \
  entry("recurrence", Recurrence, "arcspan/literature/recurrence_method.hpp") \
  entry("recurrence-four", RecurrenceFour, "arcspan/literature/recurrence_four.hpp") \
  entry("phong", Phong, "arcspan/literature/phong.hpp") \
  entry("phong-reciprocal", PhongReciprocal, "arcspan/literature/phong.hpp") \
  entry("phong-segment", PhongSegment, "arcspan/literature/phong_segment.hpp") \
  entry("slerp", Slerp, "arcspan/literature/slerp.hpp") \
  entry("kuijk-blake", KuijkBlake, "arcspan/literature/kuijk_blake.hpp") \
  entry("lyon", Lyon, "arcspan/literature/lyon.hpp") \
  entry("duff", Duff, "arcspan/literature/duff.hpp") \
  entry("reflection-map", ReflectionMap, "arcspan/literature/reflection_map.hpp") \
  entry("arc-vector", ArcVector, "arcspan/literature/arc_vector.hpp") \
  entry("dichotomy-linear", DichotomyLinear, "arcspan/literature/dichotomy.hpp") \
  entry("dichotomy-quadratic", DichotomyQuadratic, "arcspan/literature/dichotomy.hpp") \
  entry("dichotomy-cubic", DichotomyCubic, "arcspan/literature/dichotomy.hpp") \
  entry("dichotomy-root", DichotomyRoot, "arcspan/literature/dichotomy.hpp") \
  entry("dichotomy-printed-linear", DichotomyPrintedLinear, "arcspan/literature/dichotomy.hpp") \
  entry("dichotomy-printed-quadratic", DichotomyPrintedQuadratic, "arcspan/literature/dichotomy.hpp")
// clang-format on

/// Every method that this build knows (CMake option ARCSPAN_TOOLS_LITERATURE).
#ifdef ARCSPAN_NO_LITERATURE_METHODS
#define ARCSPAN_FOR_EACH_SHADING_METHOD(entry) ARCSPAN_FOR_EACH_PRODUCT_METHOD(entry)
#else
#define ARCSPAN_FOR_EACH_SHADING_METHOD(entry) \
  ARCSPAN_FOR_EACH_PRODUCT_METHOD(entry) ARCSPAN_FOR_EACH_LITERATURE_METHOD(entry)
#endif

/// The name of a function that exists once for each method: ARCSPAN_METHOD_FUNCTION(render, Arc) is
/// render_Arc.
#define ARCSPAN_METHOD_FUNCTION(verb, Class) ARCSPAN_JOIN_METHOD_FUNCTION(verb, Class)
#define ARCSPAN_JOIN_METHOD_FUNCTION(verb, Class) verb##_##Class

/// The name of a class that a macro holds, as text: ARCSPAN_NAME_OF(ARCSPAN_METHOD) is "Arc".
#define ARCSPAN_NAME_OF(Class) ARCSPAN_TEXT_OF(Class)
#define ARCSPAN_TEXT_OF(Class) #Class

namespace arcspan::tools {

/// Whether the class of this name is in the second list.
[[nodiscard]] constexpr bool is_literature_method(std::string_view class_name) {
#define ARCSPAN_COMPARE_CLASS(name, Class, header) class_name == #Class ||
  return ARCSPAN_FOR_EACH_LITERATURE_METHOD(ARCSPAN_COMPARE_CLASS) false;
#undef ARCSPAN_COMPARE_CLASS
}

/// Whether there is a renderer without virtual calls for the class of this name. The pictures are the same.
[[nodiscard]] constexpr bool draws_directly([[maybe_unused]] std::string_view class_name) {
#if defined(ARCSPAN_ALWAYS_VIRTUAL)  // drawn slower and compiled faster
  return false;
#elif defined(ARCSPAN_LITERATURE_ALWAYS_VIRTUAL)
  return !is_literature_method(class_name);
#else
  return true;
#endif
}

/// Whether the tools draw textures, vertex colours, transparency and fog with the class of this name. Segment
/// has its colours at every 2^j-th pixel only.
[[nodiscard]] constexpr bool draws_effects([[maybe_unused]] std::string_view class_name) {
#ifdef ARCSPAN_WITHOUT_EFFECTS
  return false;
#else
  return class_name == "Flat" || class_name == "Gouraud" || class_name == "Arc";
#endif
}

}  // namespace arcspan::tools
