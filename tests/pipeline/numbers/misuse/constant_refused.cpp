// SPDX-License-Identifier: MIT
// A constant that make() would refuse does not compile: the far plane is nearer than the near one.
#include <arcspan/vertex/clip_transform.hpp>

using namespace arcspan;

constexpr ClipTransform kInsideOut =
    ClipTransform::of({Rotation::identity(), {}},
                      {PixelLength::of(100), ObjectLength::of(200), ObjectLength::of(100)}, {64, 64});
