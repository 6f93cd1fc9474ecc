// SPDX-License-Identifier: MIT
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <arcspan_tools/bench/parallel_bands.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <barrier>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

namespace arcspan::tools {
namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Method = Arc<Light>;
using Frame = hal::Framebuffer<Rgb565>;
using Clock = std::chrono::steady_clock;

}  // namespace

struct ParallelBands::Work {
  /// The memory that one thread does not share.
  class Band {
   public:
    Band(const RenderJob& job, const Light& light, std::span<Rgb565::Word> memory, std::int32_t first,
         std::int32_t rows)
        : job_(job),
          light_(light),
          frame_(memory, job.transform.viewport().width, rows, first),
          depth_memory_(DepthBuffer::words(job.transform.viewport().width, rows)),
          depth_(depth_memory_, job.transform.viewport().width, rows, first),
          cache_(part().mesh.vertex_count()) {}

    void clear() {
      frame_.clear(job_.background);
      depth_.clear();
    }
    [[nodiscard]] Status draw() {
      return draw_mesh<Method>(part().mesh, job_.transform, light_, frame_, depth_, std::span(cache_),
                               {part().two_sided})
          .status;
    }

   private:
    [[nodiscard]] const RenderPart& part() const { return job_.parts[0]; }

    const RenderJob& job_;
    const Light& light_;
    Frame frame_;
    std::vector<std::uint16_t> depth_memory_;
    DepthBuffer depth_;
    std::vector<CachedVertex<Method>> cache_;
  };

  RenderJob job;
  Light light;
  std::vector<Rgb565::Word> memory;
  std::vector<std::unique_ptr<Band>> bands;

  std::vector<std::int32_t> borders;  ///< rows where bands begin, and the last ends
  std::vector<double> own;            ///< milliseconds of processor time of each band's quickest frame

  Work(const RenderJob& wanted, std::uint32_t threads) : job(wanted) {
    if (job.parts.size() != 1 || job.lights.size() != 1 || job.highlight != Highlight::kPhong) {
      throw Failure("bands in parallel", "are drawn with one material, one light and Phong's highlight");
    }
    Status status = Light::make(job.parts[0].material, {job.lights[0]}, job.to_eye, light);
    if (ok(status)) status = light.set_tolerance(job.tolerance);
    if (!ok(status)) throw Failure("illumination", to_string(status));
    const Viewport& size = job.transform.viewport();
    memory.resize(Frame::words(size.width, size.height));
    const auto count = std::min(static_cast<std::int32_t>(threads), size.height);
    for (std::int32_t i = 0; i <= count; ++i) borders.push_back(size.height * i / count);
    make_bands();
  }

  void make_bands() {
    bands.clear();
    std::fill(memory.begin(), memory.end(), Rgb565::Word{});  // nothing stays of what had other borders
    const std::int32_t width = job.transform.viewport().width;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
      const std::int32_t rows = borders[i + 1] - borders[i];
      const std::span rest = std::span(memory).subspan(Frame::words(width, borders[i]));
      bands.push_back(
          std::make_unique<Band>(job, light, rest.first(Frame::words(width, rows)), borders[i], rows));
    }
  }

  /// Gives every band rows in proportion to what it drew of them in its time; one at least.
  void move_borders() {
    constexpr double kLeast = 1e-6;  // a clock too coarse for a band says 0
    std::vector<double> rows;
    for (std::size_t i = 0; i < own.size(); ++i) {
      rows.push_back((borders[i + 1] - borders[i]) / std::max(own[i], kLeast));
    }
    const double all = std::accumulate(rows.begin(), rows.end(), 0.0);
    const std::int32_t height = borders.back();
    double until = 0;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      until += rows[i] / all * height;
      const auto left = static_cast<std::int32_t>(rows.size() - i - 1);
      borders[i + 1] =
          std::clamp(static_cast<std::int32_t>(std::lround(until)), borders[i] + 1, height - left);
    }
    make_bands();
  }
};

ParallelBands::ParallelBands(const RenderJob& job, std::uint32_t threads)
    : work_(std::make_unique<Work>(job, std::max(threads, 1u))) {}

ParallelBands::~ParallelBands() = default;

ParallelBands::FrameTime ParallelBands::draw(std::int32_t repeats) {
  const std::size_t count = work_->bands.size();
  // The last to arrive notes the time: all are ready, then all are done, and so on.
  bool drawing = false;
  Clock::time_point begin;
  Clock::duration quickest = Clock::duration::max();
  const auto note_time = [&]() noexcept {
    const Clock::time_point now = Clock::now();
    if (drawing) quickest = std::min(quickest, now - begin);
    begin = now;
    drawing = !drawing;
  };
  std::barrier together(static_cast<std::ptrdiff_t>(count), note_time);
  std::vector<Status> results(count, Status::kOk);
  std::vector<double>& own = work_->own;
  own.assign(count, INFINITY);
  const auto draw_frames = [&](std::size_t i) {
    for (std::int32_t frame = 0; frame < repeats; ++frame) {
      work_->bands[i]->clear();
      together.arrive_and_wait();
      const double start = processor_milliseconds();
      const Status status = work_->bands[i]->draw();
      own[i] = std::min(own[i], processor_milliseconds() - start);
      if (!ok(status)) results[i] = status;
      together.arrive_and_wait();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < count; ++i) threads.emplace_back(draw_frames, i);
    draw_frames(0);
  }
  for (const Status status : results) {
    if (!ok(status)) throw Failure("pipeline", to_string(status));
  }
  return {std::chrono::duration<double, std::milli>(quickest).count(),
          *std::max_element(own.begin(), own.end())};
}

void ParallelBands::balance(std::int32_t rounds) {
  constexpr std::int32_t kFrames = 8;
  for (std::int32_t i = 0; i < rounds; ++i) {
    static_cast<void>(draw(kFrames));
    work_->move_borders();
  }
}

Image ParallelBands::image() const {
  const Viewport& size = work_->job.transform.viewport();
  Image image(size.width, size.height);
  for (std::size_t i = 0; i < work_->memory.size(); ++i) image.pixels[i] = Rgb565::decode(work_->memory[i]);
  return image;
}

}  // namespace arcspan::tools
