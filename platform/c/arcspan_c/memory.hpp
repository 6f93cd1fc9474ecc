// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace arcspan::c {

/// Parts of a block of memory, one behind the other. The first pass adds their sizes, the second, which has
/// the memory, gives their addresses.
class MemoryParts {
 public:
  MemoryParts() = default;
  explicit MemoryParts(void* memory) {
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(memory);
    next_ = static_cast<std::byte*>(memory) + (kAlignment - address % kAlignment) % kAlignment;
  }

  /// Room for `count` objects of `size` bytes, or null in the first pass.
  void* take(std::size_t size, std::size_t count) {
    const std::uint64_t taken = (std::uint64_t{size} * count + kAlignment - 1) / kAlignment * kAlignment;
    bytes_ += taken;
    if (next_ == nullptr) return nullptr;
    std::byte* const at = next_;
    next_ += static_cast<std::size_t>(taken);
    return at;
  }
  template <class T>
  T* take(std::size_t count = 1) {
    static_assert(alignof(T) <= kAlignment);
    return static_cast<T*>(take(sizeof(T), count));
  }
  /// The bytes that all take, wherever the block begins; SIZE_MAX if they are more.
  [[nodiscard]] std::size_t bytes() const {
    return bytes_ < SIZE_MAX ? static_cast<std::size_t>(bytes_) : SIZE_MAX;
  }

 private:
  static constexpr std::size_t kAlignment = 8;

  std::byte* next_ = nullptr;
  std::uint64_t bytes_ = kAlignment - 1;
};

}  // namespace arcspan::c
