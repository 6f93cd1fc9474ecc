// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/scene/draw_part.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>

namespace arcspan {

namespace detail {

/// The largest of some sizes.
[[nodiscard]] consteval std::size_t largest_of(std::initializer_list<std::size_t> sizes) {
  std::size_t most = 0;
  for (const std::size_t size : sizes) most = size > most ? size : most;
  return most;
}

template <class List>
struct MethodsInMemory;

/// The shading methods that a scene's memory lists, and the sizes that they need.
template <class... Methods>
struct MethodsInMemory<MethodList<Methods...>> {
  static_assert(sizeof...(Methods) > 0);
  using UseList = MethodList<typename UseOf<Methods>::Type...>;

  static constexpr const UseFacts* kFacts[] = {&kUseFacts<typename UseOf<Methods>::Type>...};
  static constexpr std::size_t kVertexBytes =
      largest_of({kUseFacts<typename UseOf<Methods>::Type>.vertex_bytes...});
  /// The bytes of the vertices of so many objects, each of which begins at a multiple of kVertexAlignment.
  template <class Count>
  [[nodiscard]] static constexpr Count vertex_memory(Count objects, Count vertices) {
    return static_cast<Count>(kVertexBytes * vertices + (kVertexAlignment - 1) * objects);
  }
  static constexpr std::size_t kLightingBytes =
      largest_of({sizeof(typename UseOf<Methods>::Type::Method::Lighting)...});
};

}  // namespace detail

/// Memory for drawing a scene, usually a static variable. `Objects` is the most that are
/// in view at a time. `Vertices` is at least the number of vertices of the largest mesh, or 0: then each
/// triangle transforms its own three vertices. If there is room for the vertices of all objects in view, they
/// are kept from band to band. `Triangles` is the number of triangles, of all parts, whose rows are kept for
/// further bands, 2.1 bytes each. In the order of the scene each object in view gets room for all of its
/// parts or none: without its rows a triangle costs about 40 instructions in each band that its object
/// reaches. It needs no initialisation and may be used for any scene. `List` is a MethodList.
template <class List, std::size_t Objects, std::size_t Vertices = 0, std::size_t Triangles = 0>
class SceneMemory {
  using Listed = detail::MethodsInMemory<List>;

 public:
  static_assert(Objects <= 65535);

  /// @cond for draw_mesh() and draw_scene(), not in the reference
  using UseList = typename Listed::UseList;
  using KeptRows = std::conditional_t<Triangles != 0, detail::PartRows, detail::NoRows>;
  static constexpr bool kHasVertices = Vertices != 0;
  [[nodiscard]] static constexpr Status status() { return Status::kOk; }
  [[nodiscard]] void* lighting() { return lighting_; }
  [[nodiscard]] std::span<unsigned char> scratch() { return {lighting_, Listed::kLightingBytes}; }
  [[nodiscard]] detail::SceneFrame frame() {
    return {header_,        {static_cast<detail::SceneSlot*>(static_cast<void*>(slots_)), Objects},
            order_,         {vertices_, kVertexMemory},
            {rows_, kRows}, kHasVertices,
            Listed::kFacts};
  }
  /// @endcond

 private:
  detail::SceneHeader header_;
  std::uint16_t order_[Objects > 0 ? Objects : 1] = {};
  // Bytes, because initialised slots would take flash too.
  alignas(
      detail::SceneSlot) unsigned char slots_[sizeof(detail::SceneSlot) * (Objects > 0 ? Objects : 1)] = {};
  alignas(8) unsigned char lighting_[Listed::kLightingBytes] = {};
  static constexpr std::size_t kVertexMemory = kHasVertices ? Listed::vertex_memory(Objects, Vertices) : 0;
  alignas(8) unsigned char vertices_[kVertexMemory + 1] = {};
  static constexpr std::size_t kRows = TriangleRows::entries(Triangles);
  TriangleRows rows_[kRows > 0 ? kRows : 1] = {};
};

/// The room of a SceneMemoryView, as the arguments of SceneMemory state it.
struct SceneLimits {
  std::uint16_t objects = 0;
  std::uint32_t vertices = 0;   ///< 0 refuses every object that has vertices
  std::uint32_t triangles = 0;  ///< whose rows are kept
};

/// A SceneMemory over bytes that the caller provides, with limits that are set when the program runs. Scenes
/// are drawn by the code that keeps vertices. It may be moved, the bytes may not.
template <class List>
class SceneMemoryView {
  using Listed = detail::MethodsInMemory<List>;

 public:
  /// The bytes that `limits` need, at any address; SIZE_MAX if they are more than that.
  [[nodiscard]] static constexpr std::size_t bytes(const SceneLimits& limits) {
    const std::uint64_t all = kAlignment - 1 + bytes_but_vertices(limits.objects) + vertex_bytes(limits) +
                              sizeof(TriangleRows) * rows(limits);
    return all < SIZE_MAX ? static_cast<std::size_t>(all) : SIZE_MAX;
  }

  /// Without memory: status() is kBufferTooSmall.
  SceneMemoryView() = default;
  /// status() is kBufferTooSmall unless `memory` has bytes(limits). prepare_scene() returns it.
  SceneMemoryView(std::span<std::byte> memory, const SceneLimits& limits) {
    const std::size_t wanted = bytes(limits);
    if (memory.size() < wanted || wanted == SIZE_MAX) return;
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(memory.data());
    first_ = memory.data() + (kAlignment - address % kAlignment) % kAlignment;
    limits_ = limits;
  }

  [[nodiscard]] Status status() const { return first_ != nullptr ? Status::kOk : Status::kBufferTooSmall; }
  [[nodiscard]] const SceneLimits& limits() const { return limits_; }

  /// @cond for draw_mesh() and draw_scene(), not in the reference
  using UseList = typename Listed::UseList;
  using KeptRows = detail::PartRows;
  static constexpr bool kHasVertices = true;
  [[nodiscard]] void* lighting() { return first_; }
  [[nodiscard]] std::span<unsigned char> scratch() {
    return {static_cast<unsigned char*>(lighting()), Listed::kLightingBytes};
  }
  [[nodiscard]] detail::SceneFrame frame() {
    std::byte* const entries = first_ + kLighting;
    std::byte* const order = entries + sizeof(detail::SceneSlot) * limits_.objects;
    std::byte* const vertices = first_ + static_cast<std::size_t>(bytes_but_vertices(limits_.objects));
    const auto of_vertices = static_cast<std::size_t>(vertex_bytes(limits_));
    return {header_,
            {static_cast<detail::SceneSlot*>(static_cast<void*>(entries)), limits_.objects},
            {static_cast<std::uint16_t*>(static_cast<void*>(order)), limits_.objects},
            {static_cast<unsigned char*>(static_cast<void*>(vertices)), of_vertices},
            {static_cast<TriangleRows*>(static_cast<void*>(vertices + of_vertices)),
             static_cast<std::size_t>(rows(limits_))},
            kHasVertices,
            Listed::kFacts};
  }
  /// @endcond

 private:
  static constexpr std::size_t kAlignment = 8;
  static_assert(alignof(detail::SceneSlot) <= kAlignment);
  [[nodiscard]] static constexpr std::uint64_t aligned(std::uint64_t bytes) {
    return (bytes + kAlignment - 1) / kAlignment * kAlignment;
  }
  static constexpr auto kLighting = static_cast<std::size_t>(aligned(Listed::kLightingBytes));
  [[nodiscard]] static constexpr std::uint64_t vertex_bytes(const SceneLimits& limits) {
    return Listed::template vertex_memory<std::uint64_t>(limits.objects, limits.vertices);
  }
  [[nodiscard]] static constexpr std::uint64_t rows(const SceneLimits& limits) {
    return TriangleRows::entries(std::uint64_t{limits.triangles});
  }
  static_assert(alignof(TriangleRows) == 1);  // they follow the vertices
  /// Lighting, slots and their order, in this order.
  [[nodiscard]] static constexpr std::uint64_t bytes_but_vertices(std::uint32_t objects) {
    constexpr std::uint64_t kObjectBytes = sizeof(detail::SceneSlot) + sizeof(std::uint16_t);
    return aligned(kLighting + kObjectBytes * objects);
  }

  detail::SceneHeader header_{};
  std::byte* first_ = nullptr;  ///< aligned; null without memory
  SceneLimits limits_{};
};

/// A SceneMemory or a SceneMemoryView.
template <class Memory>
concept SceneMemoryType = requires(Memory& memory) {
  typename Memory::UseList;
  memory.frame();
};

}  // namespace arcspan
