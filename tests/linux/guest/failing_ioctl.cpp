// SPDX-License-Identifier: MIT
// Loaded before libc by a program that uses DRM (LD_PRELOAD), makes its calls fail:
//   FAIL_CALL=N      the N-th ioctl of DRM or mapping of a device fails for want of memory
//   FAIL_NUMBER=HEX  all ioctls of DRM with this number of the kernel's drm.h fail so; with IGNORE=1 they
//   have no
//                    effect and succeed
// Then the file FAILED_FILE has the call's name and number (ff for a mapping).
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace {

int calls = 0;

bool is_number(const char* variable, int base, unsigned long number) {
  const char* text = std::getenv(variable);
  return text != nullptr && std::strtoul(text, nullptr, base) == number;
}

// Whether this call, the ioctl `number` or a mapping, is not made.
bool is_left_out(const char* name, unsigned long number) {
  ++calls;
  if (!is_number("FAIL_CALL", 10, static_cast<unsigned long>(calls)) && !is_number("FAIL_NUMBER", 16, number))
    return false;
  if (std::FILE* out = std::fopen(std::getenv("FAILED_FILE"), "w")) {
    std::fprintf(out, "%s %lx\n", name, number & 0xFF);
    std::fclose(out);
  }
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" int ioctl(int fd, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  constexpr unsigned kDrm = 'd';  // DRM_IOCTL_BASE
  if (_IOC_TYPE(request) == kDrm && is_left_out("ioctl", _IOC_NR(request)))
    return std::getenv("IGNORE") == nullptr ? -1 : 0;
  return static_cast<int>(::syscall(SYS_ioctl, fd, request, argument));
}

extern "C" void* mmap(void* address, std::size_t length, int protection, int flags, int fd,
                      off_t offset) noexcept {
  constexpr unsigned long kNone = ~0UL;
  if ((flags & MAP_SHARED) != 0 && fd >= 0 && is_left_out("mmap", kNone)) return MAP_FAILED;
  const long result = ::syscall(SYS_mmap, address, length, protection, flags, fd, offset);
  return reinterpret_cast<void*>(result);  // syscall() has set errno; -1 is MAP_FAILED
}
