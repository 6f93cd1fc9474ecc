// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <string>

namespace arcspan::linux_host {

/// Outcome of a request to the kernel: a status with a one-line explanation.
struct [[nodiscard]] Result {
  Status status = Status::kOk;
  /// The failed action or the reason, without a full stop; a string literal.
  const char* action = "";
  /// errno from the kernel; 0 if no call failed.
  int error = 0;

  /// A failure with the current errno.
  [[nodiscard]] static Result from_errno(const char* action, Status status = Status::kTransferFailed);
  /// A failure without an errno.
  [[nodiscard]] static constexpr Result refused(const char* action, Status status = Status::kUnsupported) {
    return {status, action, 0};
  }

  /// Returns `action`, followed by ": " and the text of errno if there is one.
  [[nodiscard]] std::string text() const;
};

[[nodiscard]] constexpr bool ok(const Result& result) { return arcspan::ok(result.status); }

}  // namespace arcspan::linux_host
