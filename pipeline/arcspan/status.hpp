// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan {

/// What became of an operation. Errors are values everywhere in pipeline/ and hal/; every function that
/// can fail returns one of these and states which.
enum class [[nodiscard]] Status : std::uint8_t{
    kOk = 0,
    kInvalidArgument,  ///< an argument is outside the range its function states
    kIndexOutOfRange,  ///< a mesh index names a vertex or normal that does not exist
    kBufferTooSmall,   ///< caller memory does not hold what it has to
    kUnsupported,      ///< the device or format cannot do this
    kNotReady,         ///< the device has not been started, or is asleep
    kBusy,             ///< a transfer is still under way, or the device signals busy
    kTimeout,          ///< the device stayed busy for longer than the stated limit
    kTransferFailed,   ///< the bus reported an error
    kTransferShort,    ///< the bus accepted fewer bytes than it was given
    kTruncated,        ///< data ends before it is complete
    kCorrupted,        ///< data does not agree with its checksum or with itself
};

/// A short, stable, lower-case name for logs: "ok", "invalid argument", ...
[[nodiscard]] const char* to_string(Status status);

[[nodiscard]] constexpr bool ok(Status status) { return status == Status::kOk; }

namespace detail {

/// Never defined: names the reason when a constant is not accepted.
void constant_refused();

}  // namespace detail

}  // namespace arcspan
