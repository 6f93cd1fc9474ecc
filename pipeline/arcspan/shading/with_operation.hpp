// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/shading/relight.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace arcspan {

namespace detail {

/// An operation for the pixels of a row from (x, y) on.
template <class Operation>
[[nodiscard]] ARCSPAN_INLINE constexpr auto in_row(const Operation& operation,
                                                   [[maybe_unused]] std::int32_t x,
                                                   [[maybe_unused]] std::int32_t y) {
  if constexpr (requires { operation.in_row(x, y); })
    return operation.in_row(x, y);
  else
    return operation;
}

/// An operation that depends on the depth. Its Layer lives as long as a triangle.
template <class Operation>
concept LayeredOperation = requires {
  typename Operation::Layer;
};
template <class Operation>
struct LayerOf {};
template <LayeredOperation Operation>
struct LayerOf<Operation> : Operation::Layer {};

/// The run of a method, with an operation on its colours. An aggregate, so that the inner run is made in
/// place: small cores would copy it by memcpy.
template <class Inner, class Operation>
struct OperationRun {
  static constexpr bool kStartsAnywhere = requires { requires bool{Inner::kStartsAnywhere}; };
  Inner inner;
  LayerOf<Operation>& layer;
  /// Has a value before begin(), because next() passes the pixels left of the sink before that.
  [[no_unique_address]] decltype(in_row(std::declval<const Operation&>(), 0, 0)) operation{};

  /// Starts a row of a walker, or of a small triangle.
  template <class Rows, class... Row>
  ARCSPAN_INLINE constexpr explicit OperationRun(LayerOf<Operation>& of_triangle, const Rows& rows,
                                                 const Row&... row)
      : inner(rows.row(row...)), layer(of_triangle) {}

  /// The next pixel is (x, y).
  template <class Lighting>
  ARCSPAN_INLINE constexpr void begin(const Lighting& lighting, std::int32_t x, std::int32_t y) {
    if constexpr (requires { inner.begin(base_of(lighting), x, y); }) inner.begin(base_of(lighting), x, y);
    operation = in_row(lighting.operation, x, y);
  }
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto colour(const Lighting& lighting) const {
    return operation(inner.colour(base_of(lighting)));
  }
  ARCSPAN_INLINE constexpr void next() {
    inner.next();
    if constexpr (requires { operation.next(); }) operation.next();
  }
  template <class Lighting>
  requires PiecewiseRun<Inner, typename Lighting::Base>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    return inner.enter(base_of(lighting), left);
  }
  /// How many of the pixels are in the layers of the first (LayeredRun).
  template <bool As565, class Lighting>
  requires(LayeredOperation<Operation> || LayeredRun<Inner, typename Lighting::Base>)
      [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t
      enter_layer(const Lighting& lighting, Linear z, Linear dz, std::int32_t left) {
    if constexpr (LayeredRun<Inner, typename Lighting::Base>)
      left = inner.template enter_layer<As565>(base_of(lighting), z, dz, left);
    if constexpr (LayeredOperation<Operation>)
      left = layer.template enter<As565>(lighting.operation, z, dz, left, operation);
    return left;
  }

 private:
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE static constexpr const typename Lighting::Base& base_of(
      const Lighting& lighting) {
    return lighting;
  }
};

/// The walker of a method, whose runs have an operation.
template <class Walker, class Operation>
struct OperationWalker : Walker {
  using Run = OperationRun<typename Walker::Run, Operation>;
  constexpr explicit OperationWalker(const Walker& walker) : Walker(walker) {}
  // Not trivial, because compilers call memcpy for the whole on small cores.
  ARCSPAN_INLINE constexpr OperationWalker(const OperationWalker& other) : Walker(other) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(layer, static_cast<const Walker&>(*this), start);
  }
  [[no_unique_address]] mutable LayerOf<Operation> layer{};
};

/// The rows of a small triangle, whose runs have an operation.
template <class Rows, class Operation>
struct OperationSmall {
  using Run = OperationRun<typename Rows::Run, Operation>;
  Rows rows;
  [[no_unique_address]] mutable LayerOf<Operation> layer{};
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t y, std::int32_t b, std::int32_t c) const {
    return Run(layer, rows, y, b, c);
  }
};

}  // namespace detail

/// A shading method with an operation on its pixels (pixel_operation.hpp): fog, transparency. Operations
/// nest, the inner one first:
///
///     using Window = WithOperation<WithOperation<Textured<Unlit, Palette8Texels<>>, Fogged>, Opacity<>>;
///
template <class Coloured, class Operation>
struct WithOperation : Coloured {
  static_assert(!DrawsEdges<Coloured>, "operations go inside: Wireframe<WithOperation<Unlit, Operation>>");
  /// @cond for draw_scene(), not in the reference
  /// Scenes draw what is blended with the pixels below after all that is not.
  static constexpr bool kBlends = requires(const Operation& operation) {
    requires BlendedColour<decltype(detail::in_row(operation, 0, 0)(PackedRgb()))>;
  };
  /// @endcond
  using Method = Coloured;
  using DrawsSmallTrianglesAs = std::conditional_t<DrawsSmallTriangles<Method>, WithOperation, void>;
  /// The lighting of the method with the parameters of the operation.
  struct Lighting : Method::Lighting {
    using Base = typename Method::Lighting;
    constexpr Lighting() = default;
    template <class L>
    requires std::constructible_from<Base, const L&>
    constexpr explicit Lighting(const L& light, const Operation& op = {}) : Base(light), operation(op) {}
    /// Changes the operation, or another part of the material (PreparedMaterial::with).
    constexpr void set(const Operation& op) { operation = op; }
    template <class Part>
    requires requires(Base& base, const Part& part) { {base.set(part)}; }
    constexpr void set(const Part& part) { Base::set(part); }
    /// Changes the light and keeps the rest.
    template <class L>
    constexpr void relight(const L& light) {
      detail::relight(static_cast<Base&>(*this), light);
    }
    Operation operation;
  };

  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(typename Method::Prepared& prepared,
                                                            Draw&& draw) {
    return Method::walk(prepared, [&](auto walker) {
      using Walker = decltype(walker);
      return draw(detail::OperationWalker<Walker, Operation>(walker));
    });
  }
  template <class Small, class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& part, Draw&& draw) {
    return Method::walk_small(part, [&](const auto& rows) {
      return draw(detail::OperationSmall<std::remove_cvref_t<decltype(rows)>, Operation>{rows, {}});
    });
  }
};

}  // namespace arcspan
