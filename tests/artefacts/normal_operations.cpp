// SPDX-License-Identifier: MIT
#include <arcspan_tools/counting/begin_counted.hpp>
//
#include <arcspan/literature/duff.hpp>
#include <arcspan/literature/lyon.hpp>
#include <arcspan/literature/phong.hpp>
#include <arcspan/literature/recurrence_four.hpp>
#include <arcspan/literature/slerp.hpp>

//
#include <arcspan_tools/counting/end_counted.hpp>
//
#include <tests/artefacts/normal_operations.hpp>

namespace arcspan_counting {
namespace {

namespace counted = arcspan_counted;
using Raw = Counted<std::int32_t>;

/// An illumination that does nothing: of a method that uses it, the normal is what is left.
struct Nothing {
  static constexpr std::size_t kScalars = 1;
  using Scalars = arcspan_counted_std::array<counted::Cosine, 1>;
  [[nodiscard]] Scalars scalars(const counted::Direction&) const { return {}; }
  [[nodiscard]] counted::PackedRgb colour(const Scalars&) const { return {}; }
};

/// The operations of one pixel: of its colour and of the step to the next pixel.
template <class Run>
OperationCounts count_pixel(Run run) {
  OperationCounts counts;
  operation_target = &counts;
  (void)run.colour(Nothing{});
  run.next();
  operation_target = nullptr;
  return counts;
}

counted::Linear linear(double value) {
  return counted::Linear::from_raw(Raw(static_cast<std::int32_t>(value * (1 << 27))));
}
counted::LinearNormal some_normal() { return {linear(0.6), linear(0.3), linear(0.7)}; }
counted::LinearNormal some_step() { return {linear(0.01), linear(-0.02), linear(0.003)}; }

template <class Method>
OperationCounts count_linear_scalars() {
  return count_pixel(typename Method::Run{
      {linear(0.5)}, {linear(0.01)}, counted::SquaredLength::of(some_normal(), some_step())});
}

}  // namespace

OperationCounts classic_normal_operations() {
  return count_pixel(counted::Phong<Nothing>::Run{some_normal(), some_step()});
}
OperationCounts reciprocal_normal_operations() {
  return count_pixel(counted::PhongReciprocal<Nothing>::Run{some_normal(), some_step()});
}
OperationCounts lyon_operations() { return count_linear_scalars<counted::Lyon<Nothing>>(); }
OperationCounts duff_operations() { return count_linear_scalars<counted::Duff<Nothing>>(); }

OperationCounts slerp_normal_operations() {
  const counted::Direction left = counted::normalised(1, 2, 3);
  const counted::Direction right = counted::normalised(2, 1, 3);
  const auto values = [](const counted::Direction& d) {
    return counted::SlerpValues<3>{counted::convert<counted::Cosine>(d.x),
                                   counted::convert<counted::Cosine>(d.y),
                                   counted::convert<counted::Cosine>(d.z)};
  };
  const counted::SlerpArc arc = counted::SlerpArc::of(values(left), values(right));
  return count_pixel(counted::Slerp<Nothing>::Run{left, right, arc, arc.angle >> 2, arc.angle >> 6});
}

OperationCounts recurrence_operations() {
  counted::RecurrenceScalar scalar{counted::Cosine::from_raw(Raw(1 << 29)),
                                   counted::Cosine::from_raw(Raw(1 << 20))};
  OperationCounts counts;
  operation_target = &counts;
  scalar.step(Raw(20000), Raw(8));
  operation_target = nullptr;
  return counts;
}

OperationCounts four_steps_operations() {
  counted::RecurrenceScalar scalar{counted::Cosine::from_raw(Raw(1 << 29)),
                                   counted::Cosine::from_raw(Raw(1 << 20))};
  const counted::FourSteps four = counted::FourSteps::of({Raw(20000), Raw(8), Raw(0)});
  OperationCounts counts;
  operation_target = &counts;
  (void)four.step(scalar);
  operation_target = nullptr;
  return counts;
}

}  // namespace arcspan_counting
