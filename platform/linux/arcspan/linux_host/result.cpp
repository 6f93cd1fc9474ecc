// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/result.hpp>

#include <cerrno>
#include <system_error>

namespace arcspan::linux_host {

Result Result::from_errno(const char* action, Status status) { return {status, action, errno}; }

std::string Result::text() const {
  if (error == 0) return action;
  return std::string(action) + ": " + std::generic_category().message(error);
}

}  // namespace arcspan::linux_host
