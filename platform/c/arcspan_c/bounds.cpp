// SPDX-License-Identifier: MIT
#include <arcspan_c/scene.hpp>

#include <cstdint>

using namespace arcspan;

namespace {

[[nodiscard]] arcspan_length saturated(std::int64_t v) {
  return static_cast<arcspan_length>(v > INT32_MAX ? INT32_MAX : v < INT32_MIN ? INT32_MIN : v);
}

void include(std::int64_t middle, std::int64_t radius, arcspan_length& least, arcspan_length& most) {
  const arcspan_length low = saturated(middle - radius);
  const arcspan_length high = saturated(middle + radius);
  if (low < least) least = low;
  if (high > most) most = high;
}

}  // namespace

arcspan_status arcspan_bounds(const arcspan_scene* scene, arcspan_object object, arcspan_box* box) {
  const std::span<const Object> parts = scene->parts_of(object);
  if (parts.empty()) return ARCSPAN_INVALID_ARGUMENT;
  *box = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
  for (const Object& part : parts) {
    const WorldPoint middle = part.middle();
    // Rounded up, by one unit more for the middle.
    const std::int64_t radius = ((std::int64_t{part.sphere().radius} * part.scale.raw()) >> 15) + 2;
    include(middle.x.raw(), radius, box->least.x, box->most.x);
    include(middle.y.raw(), radius, box->least.y, box->most.y);
    include(middle.z.raw(), radius, box->least.z, box->most.z);
  }
  return ARCSPAN_OK;
}
