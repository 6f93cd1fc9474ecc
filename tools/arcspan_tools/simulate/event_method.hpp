// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>

#include <arcspan_tools/simulate/draw_events.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

/// A shading method with counters around each of its functions. It draws the same pixels.
namespace arcspan::tools {

/// Where the events of the drawing in progress are counted: one at a time.
struct EventTarget {
  DrawEvents events{};
  DrawEvents::Path* path = nullptr;   ///< of the current triangle
  DrawEvents::Path* light = nullptr;  ///< the same, but for a texture in perspective
  bool tints = false;                 ///< highlights have a colour, or are black

  static inline EventTarget* current = nullptr;
};

template <class Run>
struct EventRun : Run {
  explicit EventRun(const Run& run) : Run(run) {}

  template <class Lighting>
  [[nodiscard]] auto colour(const Lighting& lighting) const {
    EventTarget& target = *EventTarget::current;
    auto shown = Run::colour(lighting);
    if constexpr (MaskedColour<decltype(shown)>) {
      if (!shown.covers(0, 0)) {
        ++target.events.masked;
        return shown;
      }
    }
    ++target.path->written;
    if constexpr (requires { shown.shine; }) {
      if (shown.shine != 0) ++target.events.shiny;
    } else if constexpr (LightRun<Run, Lighting>) {
      if constexpr (requires { lighting.closeness(Run::scalars(), 0); }) {
        if (target.tints) {
          const auto scalars = Run::scalars();
          const bool looks_up = lighting.closeness(scalars, 0) > 0 && scalars[0].raw() > 0;
          if (looks_up) ++target.events.tinted;
          return shown;
        }
      }
      if (PixelLight(Run::light(lighting)).highlight.lanes != 0) ++target.events.shiny;
    }
    return shown;
  }
  void next() {
    ++EventTarget::current->path->pixels;
    Run::next();
  }
  template <class Lighting>
  std::int32_t enter(const Lighting& lighting, std::int32_t left) requires PiecewiseRun<Run, Lighting> {
    if constexpr (requires(Run run) { run.mapping.first(); }) {
      DrawEvents& events = EventTarget::current->events;
      ++events.pieces;
      const std::uint32_t before = Run::mapping.first();
      const std::int32_t count = Run::enter(lighting, left);
      if (Run::mapping.first() != before) ++events.new_levels;
      return count;
    } else {
      if constexpr (!requires(Run run) { run.mapping; }) ++EventTarget::current->path->segments;
      return Run::enter(lighting, left);
    }
  }
};

template <class Walker>
struct EventWalker {
  using Run = EventRun<typename Walker::Run>;
  Walker walker;

  [[nodiscard]] Run row(const RowStart& start) const {
    EventTarget& target = *EventTarget::current;
    ++target.light->spans;
    if (target.path != target.light) ++target.events.perspective_spans;
    return Run(walker.row(start));
  }
  void next_row() {
    ++EventTarget::current->events.rows;
    walker.next_row();
  }
  void enter_lower() { walker.enter_lower(); }
};

template <class Surface>
struct EventSurface {
  using Run = EventRun<typename Surface::Run>;
  const Surface& surface;

  [[nodiscard]] Run row(std::int32_t y, std::int32_t middle, std::int32_t bottom) const {
    ++EventTarget::current->path->spans;
    return Run(surface.row(y, middle, bottom));
  }
};

/// The number of a prepared triangle's loop over pixels.
template <class Part>
[[nodiscard]] std::size_t path_of(const Part& part) {
  if constexpr (requires { part.path; }) {
    return static_cast<std::size_t>(part.path);
  } else if constexpr (requires { part.has_levels; }) {
    using Path = decltype(part.surface.path);
    return part.has_levels ? static_cast<std::size_t>(Path::kLinearDiffuse) : path_of(part.surface);
  } else if constexpr (requires { part.light; }) {
    return path_of(part.light);
  } else {
    return 0;
  }
}

/// True if the texture of a prepared triangle is mapped in perspective.
template <class Prepared>
[[nodiscard]] bool is_in_perspective(const Prepared& prepared) {
  if constexpr (requires { prepared.texture.piece; }) {
    return prepared.texture.piece != 0;
  } else {
    return false;
  }
}

template <class Lighting, class Vertex>
[[nodiscard]] bool is_dark(const Lighting& lighting, const Vertex& a, const Vertex& b, const Vertex& c) {
  if constexpr (requires { lighting.is_dark(a.scalars, b.scalars, c.scalars); }) {
    return lighting.is_dark(a.scalars, b.scalars, c.scalars);
  } else {
    return false;
  }
}

/// True if a level of the texture has to be chosen for each triangle.
template <class Lighting>
[[nodiscard]] bool has_levels(const Lighting& lighting) {
  if constexpr (requires { lighting.texture; }) {
    return lighting.texture.size().levels != 1;
  } else {
    return false;
  }
}

template <class Plain, bool DrawsSmall = DrawsSmallTriangles<Plain>>
struct EventMethod : Plain {
  using Lighting = typename Plain::Lighting;

  [[nodiscard]] static auto shade_vertex(const Lighting& lighting, const Direction& normal) {
    ++EventTarget::current->events.shaded_vertices;
    return Plain::shade_vertex(lighting, normal);
  }
  [[nodiscard]] static auto shade_face(const Lighting& lighting, const Direction& normal) {
    ++EventTarget::current->events.faces;
    return Plain::shade_face(lighting, normal);
  }
  template <class Frame>
  static void prepare(const Lighting& lighting, Frame& frame, const typename Plain::Face& face,
                      typename Plain::Prepared& prepared) {
    Plain::prepare(lighting, frame, face, prepared);
    EventTarget& target = *EventTarget::current;
    DrawEvents& events = target.events;
    const std::size_t path = path_of(prepared);
    const int halves = static_cast<int>(frame.has_upper) + static_cast<int>(frame.has_lower);
    const int edges = frame.middle_left ? halves : 1;
    const bool dark = is_dark(lighting, frame.top->shade, frame.middle->shade, frame.bottom->shade);
    ++(dark ? events.dark : events.large[path].triangles);
    events.halves += halves;
    events.edges += edges;
    if (has_levels(lighting)) ++events.levelled;
    target.light = &events.large[path];
    target.path = target.light;
    if (!is_in_perspective(prepared)) return;
    ++events.perspective_triangles;
    events.perspective_edges += edges;
    target.path = &events.perspective[path];
  }
  template <class Draw>
  [[nodiscard]] static Status walk(typename Plain::Prepared& prepared, Draw&& draw) {
    return Plain::walk(prepared, [&](auto walker) { return draw(EventWalker<decltype(walker)>{walker}); });
  }
};

template <class Plain>
struct EventMethod<Plain, true> : EventMethod<Plain, false> {
  using DrawsSmallTrianglesAs = EventMethod;

  template <class Raster>
  [[nodiscard]] static bool prepare_small(const typename Plain::Lighting& lighting, const Raster& top,
                                          const Raster& middle, const Raster& bottom,
                                          const typename Plain::Face& face, const SmallTriangle& triangle,
                                          typename Plain::Small& small) {
    EventTarget& target = *EventTarget::current;
    DrawEvents& events = target.events;
    events.small_rows += triangle.rows;
    const std::int32_t half = first_row_at(middle.position.y);
    if (has_levels(lighting)) ++events.small_levelled;
    if (half > triangle.row && half < triangle.row + triangle.rows) ++events.small_halves;
    if (!Plain::prepare_small(lighting, top, middle, bottom, face, triangle, small)) {
      ++events.refused;
      return false;
    }
    target.path = &events.small[path_of(small)];
    ++(is_dark(lighting, top.shade, middle.shade, bottom.shade) ? events.small_dark : target.path->triangles);
    return true;
  }
  template <class Draw>
  [[nodiscard]] static Status walk_small(const typename Plain::Small& small, Draw&& draw) {
    return Plain::walk_small(small, [&](const auto& surface) {
      return draw(EventSurface<std::remove_cvref_t<decltype(surface)>>{surface});
    });
  }
};

}  // namespace arcspan::tools
