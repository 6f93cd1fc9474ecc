// SPDX-License-Identifier: MIT
// The method, the illumination, the sink and the memory of cost_program.cpp, by which all its frames are
// drawn. CMakeLists.txt defines the macros. Included by that source only, whose variables these are.
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/firmware/cost_stage.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include ARCSPAN_METHOD_HEADER

/// Where the emulator may load a setting of the method in place of its own: the length of segments as a power
/// of two, or 1 + the tolerance; else 0.
extern "C" const std::uint32_t arcspan_setting;

namespace arcspan {

#ifdef ARCSPAN_LIGHTS
using CostLight = Illumination<ARCSPAN_LIGHTS, ARCSPAN_HIGHLIGHT>;
#else
using CostLight = scenes::Light;
#endif
using CostMethod = ARCSPAN_METHOD<CostLight>;

inline constexpr std::int32_t kMostCostWidth = 320;
inline constexpr std::int32_t kMostCostHeight = 320;
inline constexpr std::size_t kMostCostVertices = 20000;

// .bss.frame is the board's large memory.
[[gnu::section(".bss.frame")]] static std::uint16_t cost_colours[kMostCostWidth * kMostCostHeight];
[[gnu::section(".bss.frame")]] static std::uint16_t cost_depths[kMostCostWidth * kMostCostHeight];
[[gnu::section(".bss.frame")]] static CachedVertex<CostMethod> cost_cache[kMostCostVertices];

/// The method's tables for one object; a reflection map has 16 KB of them. Not initialised: the constructor
/// is paid where it runs.
union CostLightingMemory {
  CostMethod::Lighting lighting;
  constexpr CostLightingMemory() {}
};
[[gnu::section(".bss.frame")]] static CostLightingMemory cost_lighting_memory;

/// Sets the loaded length of segments, or the tolerance of Arc: one step unless another is loaded.
template <class Method>
inline void set_method(typename Method::Lighting& lighting) {
  const auto setting = static_cast<std::int32_t>(arcspan_setting);
  if constexpr (requires { lighting.set_segment_bits(1); }) {
    if (setting != 0) (void)lighting.set_segment_bits(setting);
  } else if constexpr (requires { lighting.set_tolerance(1); }) {
    (void)lighting.set_tolerance(setting == 0 ? 1 : setting - 1);
  }
}

/// Makes the method's tables in that memory.
inline const CostMethod::Lighting& make_cost_lighting(const CostLight& light) {
  auto& lighting = *new (&cost_lighting_memory.lighting) CostMethod::Lighting(light);
  set_method<CostMethod>(lighting);
  return lighting;
}

#ifdef ARCSPAN_COST_OWN_SINK
/// A sink that a product writes itself: the pipeline opens and closes every run. frame_parts.py reads the
/// full names of its functions.
struct CostSink {
  using Format = Rgb565;
  using FromFirstColumn = CostSink;
  CostSink(std::uint16_t* memory, std::int32_t, std::int32_t) : colours(memory) {}
  [[nodiscard]] Rect bounds() const { return {0, 0, kCostWidth, kCostHeight}; }
  [[nodiscard]] Rgb565::Cursor open(const Span& run) { return {colours + run.y * kCostWidth, run.x}; }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }
  std::uint16_t* colours;
};
#else
using CostSink = hal::Framebuffer<Rgb565>;
#endif

}  // namespace arcspan
