// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/literature/recurrence_walker.hpp>
#include <arcspan/shading/literature/wide_rows.hpp>
#include <arcspan/status.hpp>

namespace arcspan {

/// Spherical-angular shading with scalars as S0 prints it (eq. 14), for comparison: the products of the
/// normal with L, H or V follow great circles down the edges and along the rows of every triangle with
/// normals up to 60 degrees apart, however close they are. The recurrence steps each of them by one multiply,
/// one shift and subtractions per row and per pixel (RecurrenceScalar); no triangle is a quadratic surface.
/// Arcs up to 60 degrees are within 2^-8 of bilinear SLERP, those up to 30 degrees within 1.4e-4. Wider
/// triangles are drawn as by Arc.
template <class Illumination>
struct Recurrence : Arc<Illumination> {
  using Base = Arc<Illumination>;
  using typename Base::Face;
  using typename Base::Lighting;
  using typename Base::Vertex;
  using Prepared = NarrowOrWide<RecurrenceTriangle<Base::kScalars>, Base::kScalars>;

  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame& unmeasured, const Face&, Prepared& prepared) {
    MeasuredFrame<Frame> frame(unmeasured);
    if (!prepared.prepare_if_wide(frame)) prepare_recurrence(frame, prepared.narrow);
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.is_wide) {
      return draw(WideWalker<PatchRun<Lighting, Base::kScalars>, Base::kScalars>(prepared.wide));
    }
    return draw(RecurrenceWalker<Illumination>(prepared.narrow));
  }
};

/// RecurrenceWalker with runs of another type, made of a RecurrenceRun: for the methods that draw the pixels
/// of a row otherwise than Recurrence.
template <class Illumination, class MethodRun>
class RecurrenceWalkerWith : public RecurrenceWalker<Illumination> {
 public:
  using Run = RestartedRun<RecurrenceWalkerWith, MethodRun>;
  using RecurrenceWalker<Illumination>::RecurrenceWalker;
  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(*this, start); }
  [[nodiscard]] constexpr MethodRun start_run(const RowStart& start) const {
    return MethodRun{RecurrenceWalker<Illumination>::start_run(start)};
  }
};

}  // namespace arcspan
