// SPDX-License-Identifier: MIT
#pragma once

#include <tests/frames/stage_set.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A mesh binary or a model binary, its camera and the size of the picture. A record of 0 bytes is the end.
struct ModelRecord {
  char name[24];  ///< ends with zeros
  std::uint32_t bytes;
  std::int32_t width;
  std::int32_t height;
  std::int32_t translation[3];  ///< ObjectLength
  std::int32_t focal;           ///< PixelLength
  std::int32_t near_plane;      ///< ObjectLength
  std::int32_t far_plane;       ///< ObjectLength
};

}  // namespace arcspan

/// Where the emulator loads the records of scripts/lib/cost_models.py, each followed by its binary, which is
/// padded to a multiple of 4 bytes.
extern "C" const std::byte arcspan_models[];

namespace arcspan {

[[nodiscard]] inline const ModelRecord& first_record() {
  return *static_cast<const ModelRecord*>(static_cast<const void*>(arcspan_models));
}
[[nodiscard]] inline std::span<const std::uint8_t> binary_of(const ModelRecord& model) {
  return {static_cast<const std::uint8_t*>(static_cast<const void*>(&model + 1)), model.bytes};
}
[[nodiscard]] inline const ModelRecord& next_record(const ModelRecord& model) {
  return *static_cast<const ModelRecord*>(static_cast<const void*>(binary_of(model).data() + model.bytes));
}

/// Light and rotation are those of scenes::set_stage().
[[nodiscard]] inline bool set_model_stage(const ModelRecord& model, scenes::StageSet& stage) {
  if (!ok(scenes::set_stage({model.width, model.height}, 1, {}, stage))) return false;
  Placement placement{scenes::stage_rotation({}), {}};
  for (std::size_t i = 0; i < 3; ++i) placement.translation[i] = ObjectLength::from_raw(model.translation[i]);
  const Projection projection{PixelLength::from_raw(model.focal), ObjectLength::from_raw(model.near_plane),
                              ObjectLength::from_raw(model.far_plane)};
  return ok(ClipTransform::make(placement, projection, {model.width, model.height}, stage.transform));
}

}  // namespace arcspan
