// SPDX-License-Identifier: MIT
#include <arcspan/status.hpp>

namespace arcspan {

const char* to_string(Status status) {
  switch (status) {
    case Status::kOk:
      return "ok";
    case Status::kInvalidArgument:
      return "invalid argument";
    case Status::kIndexOutOfRange:
      return "index out of range";
    case Status::kBufferTooSmall:
      return "buffer too small";
    case Status::kUnsupported:
      return "unsupported";
    case Status::kNotReady:
      return "not ready";
    case Status::kBusy:
      return "busy";
    case Status::kTimeout:
      return "timeout";
    case Status::kTransferFailed:
      return "transfer failed";
    case Status::kTransferShort:
      return "transfer short";
    case Status::kTruncated:
      return "truncated";
    case Status::kCorrupted:
      return "corrupted";
    case Status::kDepthMismatch:
      return "depth buffer does not cover the frame";
    case Status::kCacheTooSmall:
      return "vertex cache too small";
    case Status::kNearNotBeforeFar:
      return "near plane not before far plane";
    case Status::kNoViewDirection:
      return "camera has no view direction";
    case Status::kScaleOutOfRange:
      return "object scale or curve over an outline out of range";
    case Status::kTooManyLights:
      return "more lights than the shading method has";
    case Status::kTooManyObjects:
      return "more objects than the scene memory holds";
    case Status::kMethodNotListed:
      return "shading method not listed";
    case Status::kLightChanged:
      return "light differs from the material's";
    case Status::kCacheMismatch:
      return "band cache holds another object";
  }
  return "unknown status";
}

}  // namespace arcspan
