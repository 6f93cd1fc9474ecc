// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace arcspan::tools {

/// The intensities of S1's worked example (four planes around a vertex; a point P of plane 3), in doubles.
struct WorkedExample {
  double flat = 0;
  std::array<double, 3> vertices{};  ///< at A, B and C
  double gouraud = 0;                ///< with the weights as S1 applies them, I_Q = u I_A + (1 - u) I_B
  double gouraud_as_defined =
      0;  ///< with u = AQ/AB and w = BR/BC as S1 defines them, I_Q = (1 - u) I_A + u I_B
  double phong_as_defined = 0;      ///< likewise, normal normalised
  double phong_not_normalised = 0;  ///< as S1 computes it
  double phong = 0;
  double arc = 0;  ///< along great circles, S0 eq. 2
};

[[nodiscard]] WorkedExample worked_example();

}  // namespace arcspan::tools
