// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/reference_method.hpp>
#include <arcspan_tools/support/failure.hpp>

namespace arcspan::tools {
namespace {

/// Keeps the number of the sample that was drawn last (nearest) at every pixel.
struct NumberFormat {
  using Encoded = PackedRgb;
  using Word = std::uint32_t;
  static constexpr unsigned kBitsPerPixel = 32;
  static constexpr bool kDithers = false;

  class Cursor {
   public:
    Cursor(Word* row, std::int32_t x) : at_(row + x) {}
    void write(Encoded code) { *at_ = code.lanes; }
    [[nodiscard]] Encoded read() const { return {*at_}; }
    void next() { ++at_; }

   private:
    Word* at_;
  };

  [[nodiscard]] static std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static Encoded encode(PackedRgb c) { return c; }
  [[nodiscard]] static Encoded encode(Rgb8) { return {}; }
  [[nodiscard]] static Encoded encode_dithered(Rgb8, std::int32_t, std::int32_t) { return {}; }
  [[nodiscard]] static Rgb8 decode(Encoded) { return {}; }
};

class NumberSink {
 public:
  using Format = NumberFormat;

  explicit NumberSink(ReferencePicture& picture) : picture_(&picture) {}
  [[nodiscard]] Rect bounds() const { return {0, 0, picture_->width, picture_->height}; }
  [[nodiscard]] Format::Cursor open(const Span& run) {
    const auto row = static_cast<std::size_t>(run.y) * static_cast<std::size_t>(picture_->width);
    return {picture_->numbers.data() + row, run.x};
  }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

 private:
  ReferencePicture* picture_;
};

double to_double(Coefficient c) { return std::ldexp(c.raw(), -Coefficient::kFraction); }

/// The channels times `factor`.
std::array<double, 3> channels(const ChannelCoefficients& c, double factor) {
  return {factor * to_double(c.r), factor * to_double(c.g), factor * to_double(c.b)};
}

}  // namespace

Vec3 to_vec3(const Direction& d) {
  const auto component = [](DirectionComponent c) {
    return std::ldexp(c.raw(), -DirectionComponent::kFraction);
  };
  return {component(d.x), component(d.y), component(d.z)};
}

ReferenceIllumination::ReferenceIllumination(const RenderJob& job, const Material& material)
    : ambient(channels(material.ambient, 255)),
      diffuse(channels(material.diffuse, 255)),
      specular(channels(material.specular, 255)),
      shininess(material.shininess),
      highlight_fade(to_double(material.highlight_fade)),
      phong_highlight(job.highlight == Highlight::kPhong),
      to_eye(normalised(to_vec3(job.to_eye))) {
  for (const DirectionalLight& light : job.lights) {
    lights.push_back({normalised(to_vec3(light.towards)), channels(light.colour, to_double(light.strength))});
  }
}

LightLevels ReferenceIllumination::light(Vec3 normal) const {
  LightLevels result{ambient, {}};
  for (const auto& [light, weights] : lights) {
    const double normal_light = dot(normal, light);
    if (normal_light <= 0) continue;
    const double cosine = phong_highlight ? 2 * normal_light * dot(normal, to_eye) - dot(light, to_eye)
                                          : dot(normal, normalised(light + to_eye));
    const double fade = normal_light < highlight_fade ? normal_light / highlight_fade : 1;
    const double shine = fade * std::pow(std::max(cosine, 0.0), shininess);
    for (std::size_t c = 0; c < 3; ++c) {
      result.diffuse[c] += weights[c] * diffuse[c] * normal_light;
      result.highlight[c] += weights[c] * specular[c] * shine;
    }
  }
  return result;
}

Image ReferencePicture::image(Rgb8 background) const {
  Image picture(width, height);
  const auto step = [](double level) { return static_cast<std::uint8_t>(std::lround(level)); };
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      const ReferenceSample* sample = at(x, y);
      picture.at(x, y) =
          sample == nullptr ? background
                            : Rgb8{step(sample->levels[0]), step(sample->levels[1]), step(sample->levels[2])};
    }
  }
  return picture;
}

ReferencePicture draw_reference(const RenderJob& job, ReferenceKind kind) {
  const Viewport& size = job.transform.viewport();
  ReferencePicture picture;
  picture.width = size.width;
  picture.height = size.height;
  const std::size_t area = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  picture.numbers.resize(area);
  NumberSink sink(picture);
  std::vector<CachedVertex<ReferenceMethod>> cache(most_vertices(job));
  std::vector<std::uint16_t> depth_memory(job.depth ? area : 0, DepthBuffer::kFarthest);
  const DepthBuffer depth(depth_memory, size.width, size.height);
  for (const RenderPart& part : job.parts) {
    const ReferenceMethod::Lighting lighting{kind, ReferenceIllumination(job, part.material),
                                             &picture.samples};
    const DrawOptions options{part.two_sided};
    const DrawResult drawn = job.depth ? draw_mesh<ReferenceMethod>(part.mesh, job.transform, lighting, sink,
                                                                    depth, std::span(cache), options)
                                       : draw_mesh<ReferenceMethod>(part.mesh, job.transform, lighting, sink,
                                                                    NoDepth{}, std::span(cache), options);
    if (!ok(drawn.status)) throw Failure("pipeline", to_string(drawn.status));
  }
  return picture;
}

ReferencePicture with_texels(const ReferencePicture& reference, const Image& texels) {
  ReferencePicture textured = reference;
  textured.samples.clear();
  for (std::int32_t y = 0; y < reference.height; ++y) {
    for (std::int32_t x = 0; x < reference.width; ++x) {
      const ReferenceSample* const plain = reference.at(x, y);
      if (plain == nullptr) continue;
      const Rgb8 texel = texels.at(x, y);
      ReferenceSample sample = *plain;
      sample.levels = plain->light.reflected({texel.r / 255.0, texel.g / 255.0, texel.b / 255.0});
      textured.samples.push_back(sample);
      textured.numbers[static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width) +
                       static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(textured.samples.size());
    }
  }
  return textured;
}

}  // namespace arcspan::tools
