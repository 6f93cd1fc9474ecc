// SPDX-License-Identifier: MIT
#include <arcspan/shading/arc/arc.hpp>

#include <tests/support/accuracy.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/probe.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/run_list.hpp>
#include <tests/support/slerp_oracle.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace arcspan::test {

void ErrorFigure::add(double error) {
  max = std::max(max, std::abs(error));
  sum_of_squares += error * error;
  ++count;
}
void ErrorFigure::add(const ErrorFigure& other) {
  max = std::max(max, other.max);
  sum_of_squares += other.sum_of_squares;
  count += other.count;
}
double ErrorFigure::rms() const {
  return count == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(count));
}

void AccuracyFigures::add(const AccuracyFigures& other) {
  triangles += other.triangles;
  pixels += other.pixels;
  normal_light.add(other.normal_light);
  normal_half.add(other.normal_half);
  normal_eye.add(other.normal_eye);
  matt.add(other.matt);
  blinn.add(other.blinn);
  phong.add(other.phong);
  matt_steps = std::max(matt_steps, other.matt_steps);
  blinn_steps = std::max(blinn_steps, other.blinn_steps);
  phong_steps = std::max(phong_steps, other.phong_steps);
  missing_pixels += other.missing_pixels;
}

namespace {

using Method = Arc<Probe>;
constexpr std::int32_t kPicture = 2048;

/// Light and eye of one triangle, exact and as the pipeline gets them.
struct Lighting {
  Vec3 light;
  Vec3 half;
  Vec3 eye;
  Material matt_material;
  Material shiny_material;
};

struct Subject {
  TriangleOracle::Corner corner[3];
};

/// Three normals the widest pair of which is `angle` apart.
void random_normals(Random& random, double angle, Subject& subject) {
  const Vec3 a = random_unit(random);
  const Vec3 b = tilted(random, a, angle);
  Vec3 c = a;
  const int kind = random.integer(0, 9);
  if (kind == 0) {
    c = Slerp(a, b)(random.unit());  // all on one great circle
  } else if (kind > 1) {
    do {
      c = tilted(random, a, angle * std::sqrt(random.unit()));
    } while (angle_between(b, c) > angle);
  }
  const int turn = random.integer(0, 2);
  const Vec3 normals[3] = {a, b, c};
  for (int i = 0; i < 3; ++i) subject.corner[i].normal = normals[(i + turn) % 3];
}

void random_corners(Random& random, double size, Subject& subject) {
  const double limit = std::max(0.0, 1020 - size);
  const double x = random.real(-limit, limit);
  const double y = random.real(-limit, limit);
  // Slim ones are as frequent as others: their edges and rows have the extreme step angles.
  const double slimness = random.chance(0.3) ? random.decades(0.01, 1) : 1;
  const bool flat = random.chance(0.5);
  for (TriangleOracle::Corner& corner : subject.corner) {
    const double dx = random.real(-size, size) * (flat ? 1 : slimness);
    const double dy = random.real(-size, size) * (flat ? slimness : 1);
    const auto snapped = [](double v) {
      return std::clamp<std::int64_t>(std::llround(16 * v), -16384, 16383);
    };
    corner.point = {snapped(x + dx), snapped(y + dy)};
  }
}

/// Half of the highlights are put where the triangle is.
Lighting random_lighting(Random& random, Vec3 near, int shininess) {
  Lighting l;
  do {
    l.eye = random_unit(random);
    l.light = random_unit(random);
    if (random.chance(0.5)) {
      const Vec3 half = tilted(random, near, radians(random.real(0, 20)));
      l.eye = tilted(random, half, radians(random.real(0, 70)));
      l.light = 2 * dot(half, l.eye) * half - l.eye;
    }
  } while (dot(l.light, l.eye) < -0.85);  // opposite ones have no H
  l.half = normalised(l.light + l.eye);
  l.matt_material = random_material(random, false, shininess);
  l.shiny_material = random_material(random, true, shininess);
  return l;
}

RasterVertex<Method> to_vertex(const TriangleOracle::Corner& corner, const Probe& probe) {
  // As it comes from a mesh: packed, unpacked, shaded.
  const auto big = [](double v) { return static_cast<std::int32_t>(std::lround(v * (1 << 28))); };
  const Direction normal =
      unpack_normal(pack_normal(big(corner.normal.x), big(corner.normal.y), big(corner.normal.z)));
  return {{static_cast<std::int16_t>(corner.point.x), static_cast<std::int16_t>(corner.point.y), 0},
          Method::shade_vertex(probe, normal)};
}

class Measurement {
 public:
  explicit Measurement(const AccuracyTask& task)
      : task_(task), random_(task.seed), runs_({0, 0, kPicture, kPicture}) {}

  [[nodiscard]] AccuracyFigures operator()() {
    for (int i = 0; i < task_.triangles; ++i) one_triangle();
    return figures_;
  }

 private:
  void one_triangle() {
    Subject subject;
    random_normals(random_, radians(random_.real(task_.from_degrees, task_.to_degrees)), subject);
    const double size = random_.decades(task_.smallest, task_.largest);
    random_corners(random_, size, subject);
    const Lighting lighting = random_lighting(random_, subject.corner[0].normal, task_.shininess);
    draw(subject, lighting, size);
    compare(subject, lighting);
    ++figures_.triangles;
  }

  void draw(const Subject& subject, const Lighting& lighting, double size) {
    samples_.clear();
    runs_.runs.clear();
    Probe probe;
    probe.shininess = task_.shininess;
    probe.limits = task_.limits;
    probe.samples = &samples_;
    probe.axes = {to_direction(lighting.light),
                  half_way(to_direction(lighting.light), to_direction(lighting.eye)),
                  to_direction(lighting.eye)};
    const std::array<DirectionalLight, 1> lights{DirectionalLight{probe.axes[0]}};
    if (!ok(Probe::Blinn::make(lighting.matt_material, lights, probe.axes[2], matt_)) ||
        !ok(Probe::Blinn::make(lighting.shiny_material, lights, probe.axes[2], blinn_)) ||
        !ok(Probe::Phong::make(lighting.shiny_material, lights, probe.axes[2], phong_))) {
      ++figures_.missing_pixels;
    }
    probe.matt = &matt_;
    probe.blinn = &blinn_;
    probe.phong = &phong_;
    RasterStage<Method, RunList> stage(runs_, kPicture, kPicture, probe);
    stage.clip_to(window(subject, size));
    const RasterVertex<Method> v[3] = {to_vertex(subject.corner[0], probe),
                                       to_vertex(subject.corner[1], probe),
                                       to_vertex(subject.corner[2], probe)};
    stage.draw(v[0], v[1], v[2]);
  }

  /// The whole picture, or 48 by 48 pixels somewhere in a large triangle.
  Rect window(const Subject& subject, double size) {
    if (size < 100) return runs_.bounds();
    double x = 0;
    double y = 0;
    double sum = 0;
    for (const TriangleOracle::Corner& corner : subject.corner) {
      const double weight = random_.unit();
      sum += weight;
      x += weight * static_cast<double>(corner.point.x);
      y += weight * static_cast<double>(corner.point.y);
    }
    const auto left = static_cast<std::int32_t>(x / sum / 16) + kPicture / 2 - 24;
    const auto top = static_cast<std::int32_t>(y / sum / 16) + kPicture / 2 - 24;
    return {std::max(left, 0), std::max(top, 0), std::min(left + 48, kPicture), std::min(top + 48, kPicture)};
  }

  void compare(const Subject& subject, const Lighting& lighting) {
    const TriangleOracle oracle(subject.corner[0], subject.corner[1], subject.corner[2]);
    const IlluminationOracle matt = to_oracle(lighting.matt_material);
    const IlluminationOracle shiny = to_oracle(lighting.shiny_material);
    std::size_t next = 0;
    for (const Span& run : runs_.runs) {
      const TriangleOracle::Row row = oracle.row(run.y - kPicture / 2);
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        if (next == samples_.size()) {
          ++figures_.missing_pixels;
          return;
        }
        pixel(samples_[next++], row.at(x - kPicture / 2), lighting, matt, shiny);
      }
    }
    figures_.missing_pixels += samples_.size() - next;
  }

  void pixel(const ProbeSample& sample, Vec3 normal, const Lighting& lighting, const IlluminationOracle& matt,
             const IlluminationOracle& shiny) {
    const double light = dot(normal, lighting.light);
    const double half = dot(normal, lighting.half);
    const double eye = dot(normal, lighting.eye);
    figures_.normal_light.add(to_double(sample.scalars[0]) - light);
    figures_.normal_half.add(to_double(sample.scalars[1]) - half);
    figures_.normal_eye.add(to_double(sample.scalars[2]) - eye);
    const double reflected = 2 * light * eye - dot(lighting.light, lighting.eye);
    colour(sample.matt, matt, light, half, figures_.matt, figures_.matt_steps);
    colour(sample.blinn, shiny, light, half, figures_.blinn, figures_.blinn_steps);
    colour(sample.phong, shiny, light, reflected, figures_.phong, figures_.phong_steps);
    ++figures_.pixels;
  }

  /// The highlight ends sharply where N·L = 0. Within the error of N·L either side of the step is right.
  static void colour(Rgb8 got, const IlluminationOracle& oracle, double light, double cosine,
                     ErrorFigure& figure, int& steps) {
    const bool lit = light > 0;
    const IlluminationOracle::ChannelLevels truth = oracle.levels(light, cosine, lit);
    const bool border = std::abs(light) < 1.2e-3;
    const IlluminationOracle::ChannelLevels other = border ? oracle.levels(light, cosine, !lit) : truth;
    const double channels[3] = {double(got.r), double(got.g), double(got.b)};
    for (std::size_t c = 0; c < 3; ++c) {
      const bool nearer = std::abs(channels[c] - other[c]) < std::abs(channels[c] - truth[c]);
      const double best = nearer ? other[c] : truth[c];
      figure.add(channels[c] - best);
      steps = std::max(steps, static_cast<int>(std::abs(channels[c] - std::round(best))));
    }
  }

  AccuracyTask task_;
  Random random_;
  RunList runs_;
  std::vector<ProbeSample> samples_;
  Probe::Blinn matt_;
  Probe::Blinn blinn_;
  Probe::Phong phong_;
  AccuracyFigures figures_;
};

}  // namespace

AccuracyFigures measure_accuracy(const AccuracyTask& task) {
  return (*std::make_unique<Measurement>(task))();
}

}  // namespace arcspan::test
