// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/framebuffer/console_guard.hpp>

namespace arcspan::linux_host::drm {

/// Stops the foreground console with `guard` if its text is on a display of the card `fd`: nobody can then
/// switch to another console, whose text or desktop could not be shown. Has no effect in the cases of
/// ConsoleGuard::take().
void stop_console(int fd, ConsoleGuard& guard);

}  // namespace arcspan::linux_host::drm
