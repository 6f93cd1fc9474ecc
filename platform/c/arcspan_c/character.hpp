// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/pose.hpp>

#include <arcspan_c/scene.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// The type that arcspan.h declares.
struct arcspan_character {
  arcspan_scene& scene;
  arcspan_object object;
  arcspan::StoredAnimation animation;
  arcspan::ClipPlayer player;
  std::span<arcspan::NodeMatrix> nodes;
  std::span<arcspan::JointMatrix> joints;  ///< of all skins, one behind the other
  std::span<std::int16_t> weights;         ///< of the morph targets of all parts, likewise

  [[nodiscard]] std::span<arcspan::JointMatrix> joints_of(std::size_t skin) const;
  [[nodiscard]] std::span<std::int16_t> weights_of(std::size_t part) const;
  /// Poses it as the player says.
  void pose();
};
