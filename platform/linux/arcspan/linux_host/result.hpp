// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <string>

namespace arcspan::linux_host {

/// What became of a request to the kernel: besides the status, enough to say it in one line.
struct [[nodiscard]] Result {
  Status status = Status::kOk;
  /// What was tried or what is wrong, in words without a full stop; a string literal.
  const char* action = "";
  /// The errno that the kernel gave; 0 if the kernel was not asked or did not refuse.
  int error = 0;

  /// A failure with the present errno.
  [[nodiscard]] static Result from_errno(const char* action, Status status = Status::kTransferFailed);
  /// A failure that no call of the kernel is to blame for.
  [[nodiscard]] static constexpr Result refused(const char* action, Status status = Status::kUnsupported) {
    return {status, action, 0};
  }

  /// `action`, or `action: what errno means`.
  [[nodiscard]] std::string text() const;
};

[[nodiscard]] constexpr bool ok(const Result& result) { return arcspan::ok(result.status); }

}  // namespace arcspan::linux_host
