// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

// The version of these headers. platform/c/arcspan.h defines the same macros; the VERSION in CMakeLists.txt
// decides, and packaging/check-manifests compares.
#define ARCSPAN_VERSION_MAJOR 0
#define ARCSPAN_VERSION_MINOR 1
#define ARCSPAN_VERSION_PATCH 0
#define ARCSPAN_VERSION_TEXT "0.1.0"
/// A number to compare: 10203 is version 1.2.3.
#define ARCSPAN_VERSION \
  (ARCSPAN_VERSION_MAJOR * 10000L + ARCSPAN_VERSION_MINOR * 100L + ARCSPAN_VERSION_PATCH)

namespace arcspan {

/// The version of the compiled library, "1.2.3". It is ARCSPAN_VERSION_TEXT unless a program is linked with a
/// library of another version than its headers.
[[nodiscard]] const char* version();

}  // namespace arcspan
