// SPDX-License-Identifier: MIT
// Arbitrary integers as triangles, meshes, transforms and illuminations. The memory behind every sink is
// exactly as large as it says, so that the address sanitizer sees a write outside.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/arc_vector.hpp>
#include <arcspan/literature/dichotomy.hpp>
#include <arcspan/literature/duff.hpp>
#include <arcspan/literature/kuijk_blake.hpp>
#include <arcspan/literature/lyon.hpp>
#include <arcspan/literature/phong_segment.hpp>
#include <arcspan/literature/recurrence_four.hpp>
#include <arcspan/literature/slerp.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/pixel/sink_part.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/span/draw_command.hpp>

#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

using namespace arcspan;

namespace {

/// Takes the input apart; beyond its end everything is 0.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

  template <class T>
  [[nodiscard]] T take() {
    T value{};
    const std::size_t count = sizeof(T) < left_ ? sizeof(T) : left_;
    if (count != 0) std::memcpy(&value, at_, count);
    at_ += count;
    left_ -= count;
    return value;
  }
  /// In from ... to.
  [[nodiscard]] std::int32_t between(std::int32_t from, std::int32_t to) {
    return from +
           static_cast<std::int32_t>(take<std::uint16_t>() % static_cast<std::uint32_t>(to - from + 1));
  }
  [[nodiscard]] bool empty() const { return left_ == 0; }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

Direction take_direction(Input& in) {
  if ((in.take<std::uint8_t>() & 1) != 0) return unpack_normal(in.take<PackedNormal>());
  return normalised(in.take<std::int32_t>(), in.take<std::int32_t>(), in.take<std::int32_t>());
}

Coefficient take_coefficient(Input& in) { return Coefficient::from_raw(in.between(0, 32768)); }

ChannelCoefficients take_channels(Input& in) {
  return {take_coefficient(in), take_coefficient(in), take_coefficient(in)};
}

template <class Illumination>
Illumination take_illumination(Input& in) {
  Material material{take_channels(in), take_channels(in), take_channels(in), in.between(1, 256), {}};
  std::array<DirectionalLight, Illumination::kLights> lights;
  for (DirectionalLight& light : lights) light = {take_direction(in), take_coefficient(in)};
  if constexpr (Illumination::kFeatures.coloured_lights) {
    for (DirectionalLight& light : lights) light.colour = take_channels(in);
  }
  if constexpr (Illumination::kFeatures.fading_highlights) material.highlight_fade = take_coefficient(in);
  // Anything at all must be refused or harmless.
  if ((in.take<std::uint8_t>() & 7) == 0) {
    material.ambient.g = Coefficient::from_raw(in.take<std::int32_t>());
    lights[0].strength = Coefficient::from_raw(in.take<std::int32_t>());
    material.shininess = in.take<std::int32_t>();
    material.highlight_fade = Coefficient::from_raw(in.take<std::int32_t>());
    lights[0].colour.b = Coefficient::from_raw(in.take<std::int32_t>());
  }
  Illumination illumination;
  static_cast<void>(Illumination::make(material, lights, take_direction(in), illumination));
  static_cast<void>(illumination.set_tolerance(in.take<std::int8_t>()));
  return illumination;
}

template <class I>
void take_shade(Input& in, typename Arc<I>::Vertex& shade) {
  shade.normal = {NormalComponent::from_raw(in.take<std::int16_t>()),
                  NormalComponent::from_raw(in.take<std::int16_t>()),
                  NormalComponent::from_raw(in.take<std::int16_t>())};
  shade.deficit = in.take<std::uint16_t>();
  for (Cosine& scalar : shade.scalars) scalar = Cosine::from_raw(in.take<std::int32_t>());
}
template <class I>
void take_shade(Input& in, typename Gouraud<I>::Vertex& shade) {
  shade = {in.between(0, 65280), in.between(0, 65280), in.between(0, 65280)};
}
template <class I>
void take_shade(Input&, typename Flat<I>::Vertex&) {}

/// A position, as a rule in the guard band, often on a pixel border; some are anywhere that 16 bits reach.
RasterPosition take_position(Input& in) {
  const std::uint8_t kind = in.take<std::uint8_t>();
  const int wild = (kind & 0xF0) == 0xF0 ? 0 : 1;
  auto coordinate = [&in, wild](bool snap) {
    const std::int32_t v = in.take<std::int16_t>() >> wild;
    return static_cast<std::int16_t>(snap ? v & ~7 : v);
  };
  const std::int16_t x = coordinate((kind & 1) != 0);
  const std::int16_t y = coordinate((kind & 2) != 0);
  return {x, y, static_cast<std::uint16_t>(in.between(256, 65279))};
}

/// A sink and a depth buffer of the same random size and place.
template <class Format>
struct Target {
  Target(Input& in, std::int32_t max_width, std::int32_t max_rows)
      : width(in.between(1, max_width)),
        rows(in.between(1, max_rows)),
        first(in.between(0, max_rows)),
        memory(hal::Framebuffer<Format>::words(width, rows)),
        depths(DepthBuffer::words(width, rows)),
        sink(memory, width, rows, first),
        depth(depths, width, rows, first) {
    depth.clear();
  }
  std::int32_t width;
  std::int32_t rows;
  std::int32_t first;
  std::vector<typename Format::Word> memory;
  std::vector<std::uint16_t> depths;
  hal::Framebuffer<Format> sink;
  DepthBuffer depth;
};

template <class Method, class Format>
void fuzz_triangles(Input& in) {
  using I = typename Method::Lighting;
  const I lighting = take_illumination<I>(in);
  Target<Format> target(in, 96, 96);
  const RasterOrigin origin{in.between(-1024, 1024), in.between(-1024, 1024)};
  const RowRange rows{in.between(-1024, 0), in.between(0, 1024)};
  while (!in.empty()) {
    RasterVertex<Method> v[3];
    for (auto& vertex : v) {
      vertex.position = take_position(in);
      take_shade<I>(in, vertex.shade);
    }
    const Direction normal = take_direction(in);
    TriangleCommand<Method> command;
    if (!prepare_triangle(lighting, v[0], v[1], v[2], Method::shade_face(lighting, normal), rows, command))
      continue;
    const Rect clip = target.sink.bounds();
    if ((in.take<std::uint8_t>() & 1) != 0) {
      static_cast<void>(draw_command(command, origin, clip, lighting, target.sink, target.depth));
    } else {
      static_cast<void>(draw_command(command, origin, clip, lighting, target.sink, NoDepth{}));
    }
  }
}

Placement take_placement(Input& in) {
  Placement placement;
  const bool wild = (in.take<std::uint8_t>() & 1) != 0;
  for (auto& row : placement.rotation.m) {
    const Direction d = take_direction(in);
    row[0] = RotationEntry::from_raw(wild ? in.take<std::int32_t>() : d.x.raw() * 32767);
    row[1] = RotationEntry::from_raw(wild ? in.take<std::int32_t>() : d.y.raw() * 32767);
    row[2] = RotationEntry::from_raw(wild ? in.take<std::int32_t>() : d.z.raw() * 32767);
  }
  for (ObjectLength& t : placement.translation) {
    const int shift = in.take<std::uint8_t>() & 31;
    t = ObjectLength::from_raw(in.take<std::int32_t>() >> shift);
  }
  return placement;
}

/// The ways in which a mesh is drawn. The code that they differ in is the same for every method, so that few
/// methods take all of them.
struct Ways {
  bool with_depth = true;
  bool without_depth = true;
};
constexpr Ways kDepthOnly{.without_depth = false};
constexpr Ways kNoDepthOnly{.with_depth = false};

/// Draws into a whole sink and into some columns of another, and ends the program if their pixels differ.
template <class Format, class Draw>
void compare_part(Target<Format>& target, std::int32_t left, std::int32_t right, const Draw& draw) {
  std::vector<typename Format::Word> memory(target.memory.size());
  hal::Framebuffer<Format> other(memory, target.width, target.rows, target.first);
  target.sink.clear({});
  other.clear({});
  const Rect all = other.bounds();
  SinkPart part(other, {left, all.top, right, all.bottom});
  draw(target.sink);
  draw(part);
  for (std::int32_t y = all.top; y < all.bottom; ++y) {
    for (std::int32_t x = 0; x < all.right; ++x) {
      const Rgb8 wanted = left <= x && x < right ? target.sink.pixel(x, y) : Rgb8{};
      if (other.pixel(x, y) != wanted) std::abort();
    }
  }
}

template <class Method, class Format, Ways kWays = Ways{}>
void fuzz_mesh(Input& in) {
  using I = typename Method::Lighting;
  const I lighting = take_illumination<I>(in);
  Target<Format> target(in, 96, 96);
  const std::int32_t left = in.between(0, target.width);
  const std::int32_t right = in.between(left, target.width);
  const Placement placement = take_placement(in);
  const Projection projection{
      PixelLength::from_raw(in.take<std::int32_t>() >> (in.take<std::uint8_t>() & 31)),
      ObjectLength::from_raw(in.take<std::int32_t>() >> (in.take<std::uint8_t>() & 31)),
      ObjectLength::from_raw(in.take<std::int32_t>() >> (in.take<std::uint8_t>() & 31))};
  const bool big = (in.take<std::uint8_t>() & 3) == 0;
  const Viewport viewport{big ? in.take<std::int16_t>() : target.width,
                          big ? in.take<std::int16_t>() : target.rows + target.first};
  ClipTransform transform;
  if (!ok(ClipTransform::make(placement, projection, viewport, transform))) return;
  std::vector<ObjectPosition> positions(static_cast<std::size_t>(in.between(0, 9)));
  std::vector<PackedNormal> normals(positions.size());
  for (ObjectPosition& p : positions) p = in.take<ObjectPosition>();
  for (PackedNormal& n : normals) n = in.take<PackedNormal>();
  const bool two_sided = (in.take<std::uint8_t>() & 1) != 0;
  std::vector<CachedVertex<Method>> cache((in.take<std::uint8_t>() & 1) != 0 ? positions.size() : 0);
  std::vector<std::uint8_t> indices;
  while (!in.empty() && indices.size() < 60) {
    const auto index = in.take<std::uint8_t>();
    indices.push_back(static_cast<std::uint8_t>(positions.empty() ? index : index % (positions.size() + 1)));
  }
  MeshView mesh;
  if (!ok(MeshView::make(positions, normals, std::span<const std::uint8_t>(indices), mesh))) {
    indices.resize(indices.size() / 3 * 3);
    for (std::uint8_t& index : indices) index = index >= positions.size() ? 0 : index;
    if (!ok(MeshView::make(positions, normals, std::span<const std::uint8_t>(indices), mesh))) return;
  }
  const DrawOptions options{two_sided};
  if constexpr (kWays.with_depth) {
    static_cast<void>(
        draw_mesh<Method>(mesh, transform, lighting, target.sink, target.depth, std::span(cache), options));
  }
  if constexpr (kWays.without_depth) {
    const auto draw = [&](auto& sink) {
      static_cast<void>(
          draw_mesh<Method>(mesh, transform, lighting, sink, NoDepth{}, std::span(cache), options));
    };
    if constexpr (kWays.with_depth) {
      compare_part(target, left, right, draw);
    } else {
      draw(target.sink);
    }
  }
}

using Blinn1 = Illumination<1, Highlight::kBlinn>;
using Blinn4 = Illumination<4, Highlight::kBlinn>;
using Phong1 = Illumination<1, Highlight::kPhong>;
constexpr IlluminationFeatures kEveryFeature{.coloured_lights = true, .fading_highlights = true};
using Phong2 = Illumination<2, Highlight::kPhong, kEveryFeature>;
using GreyPhong2 = Illumination<2, Highlight::kPhong>;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  switch (in.take<std::uint8_t>() % 21) {
    case 0:
      fuzz_triangles<Arc<Blinn1>, Rgb565>(in);
      break;
    case 1:
      fuzz_triangles<Arc<Phong2>, Rgb888>(in);
      break;
    case 2:
      fuzz_triangles<Gouraud<Blinn1>, Gray4>(in);
      break;
    case 3:
      fuzz_triangles<Flat<Phong1>, Dithered<Mono>>(in);
      break;
    case 4:
      fuzz_triangles<Arc<Blinn4>, Dithered<Rgb565>>(in);
      break;
    case 5:
      fuzz_mesh<Arc<Phong1>, Rgb565>(in);
      break;
    case 6:
      fuzz_mesh<Arc<Blinn4>, Gray8, kDepthOnly>(in);
      break;
    case 7:
      fuzz_mesh<Gouraud<Phong2>, Mono, kNoDepthOnly>(in);
      break;
    case 8:
      fuzz_mesh<Flat<Blinn1>, Rgb888, kDepthOnly>(in);
      break;
    case 9:
      fuzz_mesh<Arc<Blinn1>, Dithered<Gray4>, kNoDepthOnly>(in);
      break;
    case 10:
      fuzz_mesh<Phong<Blinn1>, Rgb565, kDepthOnly>(in);
      break;
    case 11:
      fuzz_mesh<Duff<Phong1>, Rgb565, kNoDepthOnly>(in);
      break;
    case 12:
      fuzz_mesh<Lyon<Blinn1>, Rgb565, kDepthOnly>(in);
      break;
    case 13:
      fuzz_mesh<Slerp<Phong1>, Rgb565, kNoDepthOnly>(in);
      break;
    case 14:
      fuzz_mesh<KuijkBlake<Blinn1>, Rgb565, kDepthOnly>(in);
      break;
    case 15:
      fuzz_mesh<ArcVector<Phong1>, Rgb565, kNoDepthOnly>(in);
      break;
    case 16:
      fuzz_mesh<DichotomyLinear<Phong2>, Rgb565, kDepthOnly>(in);
      break;
    case 17:
      fuzz_mesh<PhongSegment<Blinn1>, Rgb565, kNoDepthOnly>(in);
      break;
    case 18:
      fuzz_mesh<RecurrenceFour<Phong1>, Rgb565, kDepthOnly>(in);
      break;
    case 19:
      fuzz_triangles<Arc<GreyPhong2>, Rgb565>(in);
      break;
    default:
      fuzz_mesh<DichotomyPrintedQuadratic<Blinn4>, Rgb565, kNoDepthOnly>(in);
      break;
  }
  return 0;
}
