// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The result of an operation. Errors are values everywhere in pipeline/ and hal/: every function that can
/// fail returns a Status and states which values it returns.
enum class [[nodiscard]] Status : std::uint8_t{
    kOk = 0,
    kInvalidArgument,   ///< an argument is outside the range that its function states
    kIndexOutOfRange,   ///< a mesh index names a vertex or normal that does not exist
    kBufferTooSmall,    ///< memory given by the caller is smaller than its function states
    kUnsupported,       ///< the device, format or machine cannot do this
    kNotReady,          ///< the device has not been started, or is asleep
    kBusy,              ///< a transfer is still under way, or the device signals busy
    kTimeout,           ///< the device stayed busy longer than the stated limit
    kTransferFailed,    ///< the bus reported an error
    kTransferShort,     ///< the bus accepted fewer bytes than it was given
    kTruncated,         ///< data ends before it is complete
    kCorrupted,         ///< data contradicts its checksum or itself
    kDepthMismatch,     ///< the depth buffer does not cover the part of the picture that is drawn
    kCacheTooSmall,     ///< the vertex cache holds fewer vertices than the mesh has
    kNearNotBeforeFar,  ///< the planes of a lens are not 0 < near < far
    kNoViewDirection,   ///< the eye coincides with its target, or looks along the camera's up direction
    kScaleOutOfRange,   ///< an object's scale, or a curve over an outline, is out of its range
    kTooManyLights,     ///< a scene has more lights than a shading method of it
    kTooManyObjects,    ///< more objects are in view than the memory of a scene holds
    kMethodNotListed,   ///< a material's shading method is not among those that the scene's memory lists
    kLightChanged,      ///< a light is not the one that a material was made for
    kCacheMismatch,     ///< the VertexCache holds another object, or clear() was forgotten
};

/// A short, stable, lower-case name for logs: "ok", "invalid argument", ... A value outside the enumeration
/// gives "unknown status".
[[nodiscard]] const char* to_string(Status status);

[[nodiscard]] constexpr bool ok(Status status) { return status == Status::kOk; }

/// Functions that are never defined. A consteval function that rejects its arguments calls one of them, so
/// that the message of the compiler contains the reason.
namespace detail::refused {

void constant_refused();  ///< for a reason that has no name of its own
void unsupported();
void index_out_of_range();
void buffer_too_small();
void near_plane_not_between_0_and_far_plane();
void no_view_direction();
void more_lights_than_the_method_has();

}  // namespace detail::refused

namespace detail {

/// Rejects the arguments of a consteval function by a status that says enough.
constexpr void refuse(Status status) {
  switch (status) {
    case Status::kUnsupported:
      return refused::unsupported();
    case Status::kIndexOutOfRange:
      return refused::index_out_of_range();
    case Status::kBufferTooSmall:
      return refused::buffer_too_small();
    case Status::kNearNotBeforeFar:
      return refused::near_plane_not_between_0_and_far_plane();
    case Status::kNoViewDirection:
      return refused::no_view_direction();
    case Status::kTooManyLights:
      return refused::more_lights_than_the_method_has();
    default:
      return refused::constant_refused();
  }
}

}  // namespace detail

}  // namespace arcspan
