// SPDX-License-Identifier: MIT
// Built without libgpiod: framebuffers and buses work, requests for pins report the reason.
#include <arcspan/linux_host/gpio/backend.hpp>

namespace arcspan::linux_host::gpio {
namespace {
constexpr Result kNone = Result::refused("pins need libgpiod, which was missing when arcspan was built");
}

const char* version() { return ""; }
Result find_line(const char*, const char*, unsigned&) { return kNone; }
Result request_output(const char*, unsigned, bool, HeldLine&) { return kNone; }
Result request_input(const char*, unsigned, HeldLine&) { return kNone; }
Result set_value(const HeldLine&, bool) { return kNone; }
Result get_value(const HeldLine&, bool&) { return kNone; }
void release(HeldLine&) {}

}  // namespace arcspan::linux_host::gpio
