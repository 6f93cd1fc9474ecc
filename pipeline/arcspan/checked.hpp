// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

/// Checks of debug builds. Some misuse is not reported by a Status, because finding it would cost time in
/// every frame: a depth buffer that was never cleared, a run of pixels outside of its framebuffer. Where
/// ARCSPAN_CHECKED is defined as 1, such a call reports its cause to on_misuse(). The CMake option of that
/// name, which is on in the debug presets, defines it for the libraries and for all that links them: all code
/// of a program must agree. Without it the checks compile to nothing, and no type has another size.
///
/// These calls are reported:
///
///   draw calls         a depth buffer whose memory does not look cleared: depths of 0 and none of 0xFFFF,
///                      or, since it was moved to another band, any that is not 0xFFFF
///                      a material or a billboard whose texture was not given
///                      a texture that does not repeat, given to a method that repeats all
///                      a mesh, transform or illumination never made, or a mesh made after its object
///   framebuffers       open() of a run, or pixel(), outside of bounds()
///   set-up             a rotation that is not orthonormal, a direction to a light or to the eye that is not
///                      a unit vector; part() of a number that a model does not have
namespace arcspan {

/// Called with the function and the cause, such as "draw: the depth buffer was never cleared". The library's
/// own prints it to stderr and aborts; a program replaces it by defining this function. Freestanding programs
/// must: the library has none for them. If it returns, the call goes on as it would without checks.
void on_misuse(const char* cause);

#if defined(ARCSPAN_CHECKED) && ARCSPAN_CHECKED
#define ARCSPAN_CHECK(right, cause) ((right) ? static_cast<void>(0) : ::arcspan::on_misuse(cause))
inline constexpr bool kIsChecked = true;
#else
#define ARCSPAN_CHECK(right, cause) static_cast<void>(0)
inline constexpr bool kIsChecked = false;
#endif

/// A number that an object keeps for its checks: which of its functions were called; 0 for none. In builds
/// without checks (`Checked` is false) it takes no memory and get() is 0.
template <bool Checked>
struct BasicCheckedState {
  constexpr void set(unsigned) {}
  [[nodiscard]] constexpr unsigned get() const { return 0; }
};
/// In builds with checks.
template <>
struct BasicCheckedState<true> {
  constexpr void set(unsigned done) { done_ = done; }
  [[nodiscard]] constexpr unsigned get() const { return done_; }

 private:
  unsigned done_ = 0;
};
/// BasicCheckedState for this build.
using CheckedState = BasicCheckedState<kIsChecked>;

}  // namespace arcspan
