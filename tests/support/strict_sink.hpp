// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace arcspan::test {

/// What a device would never tell: everything here must stay 0.
struct SinkFaults {
  std::uint64_t outside = 0;    ///< runs or pixels outside the bounds or the run
  std::uint64_t twice = 0;      ///< pixels drawn again
  std::uint64_t unpaired = 0;   ///< open without close, close of another run
  std::uint64_t empty_run = 0;  ///< runs of no pixels

  friend bool operator==(const SinkFaults&, const SinkFaults&) = default;
};

/// 8-bit colours in cells that remember how often they were drawn.
struct StrictFormat {
  struct Cell {
    Rgb8 colour;
    std::uint32_t count = 0;
  };
  using Encoded = Rgb8;
  using Word = Cell;
  static constexpr unsigned kBitsPerPixel = 24;
  static constexpr bool kDithers = false;

  class Cursor {
   public:
    Cursor(Cell* row, std::int32_t x) : at_(row + x), end_(at_), faults_(nullptr) {}
    Cursor(Cell* at, Cell* end, SinkFaults* faults) : at_(at), end_(end), faults_(faults) {}
    void write(Encoded code) {
      if (at_ >= end_) {
        if (faults_ != nullptr) ++faults_->outside;
        return;
      }
      at_->colour = code;
      if (at_->count++ != 0) ++faults_->twice;
    }
    [[nodiscard]] Encoded read() const { return at_->colour; }
    void next() { ++at_; }

   private:
    Cell* at_;
    Cell* end_;
    SinkFaults* faults_;
  };

  [[nodiscard]] static std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static Encoded encode(Rgb8 c) { return c; }
  [[nodiscard]] static Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return c; }
  [[nodiscard]] static Rgb8 decode(Encoded code) { return code; }
};

/// A picture that is stricter than any device: it counts what must not happen.
class StrictSink {
 public:
  using Format = StrictFormat;
  using Cell = StrictFormat::Cell;

  explicit StrictSink(const Rect& bounds)
      : bounds_(bounds),
        cells_(static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height())) {}

  [[nodiscard]] Rect bounds() const { return bounds_; }

  [[nodiscard]] Format::Cursor open(const Span& run) {
    if (is_open_) ++faults_.unpaired;
    is_open_ = true;
    run_ = run;
    if (run.count < 1) ++faults_.empty_run;
    if (run.y < bounds_.top || run.y >= bounds_.bottom || run.x < bounds_.left ||
        run.x + run.count > bounds_.right) {
      ++faults_.outside;
      return {cells_.data(), cells_.data(), &faults_};
    }
    ++runs_;
    Cell* const at = &cells_[index(run.x, run.y)];
    return {at, at + run.count, &faults_};
  }
  [[nodiscard]] Status close(const Span& run) {
    if (!is_open_ || !(run == run_)) ++faults_.unpaired;
    is_open_ = false;
    return Status::kOk;
  }

  [[nodiscard]] const SinkFaults& faults() const { return faults_; }
  [[nodiscard]] std::uint64_t runs() const { return runs_; }
  [[nodiscard]] const Cell& cell(std::int32_t x, std::int32_t y) const { return cells_[index(x, y)]; }
  /// The cells of row y from column `left` to before `right`; none if `right` is not greater.
  [[nodiscard]] std::span<const Cell> cells(std::int32_t left, std::int32_t right, std::int32_t y) const {
    if (right <= left) return {};
    return std::span(cells_).subspan(index(left, y), static_cast<std::size_t>(right - left));
  }
  [[nodiscard]] std::uint64_t drawn() const {
    std::uint64_t count = 0;
    for (const Cell& cell : cells_) count += cell.count != 0 ? 1u : 0u;
    return count;
  }
  [[nodiscard]] std::uint64_t missing() const { return cells_.size() - drawn(); }

  /// Empties the cells of `area` only: cheap for small triangles in a large picture.
  void clear(const Rect& area) {
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      std::fill_n(cells_.data() + index(area.left, y), area.width(), Cell{});
    }
    faults_ = {};
    runs_ = 0;
  }
  void clear() { clear(bounds_); }

  /// One line a row, '#' drawn, ' ' not, a digit for more than once; no blanks at the line's end.
  [[nodiscard]] std::string text() const {
    std::string picture;
    for (std::int32_t y = bounds_.top; y < bounds_.bottom; ++y) {
      std::string line;
      for (std::int32_t x = bounds_.left; x < bounds_.right; ++x) {
        const std::uint32_t count = cell(x, y).count;
        line += count == 0 ? ' ' : count == 1 ? '#' : static_cast<char>('0' + (count > 9 ? 9 : count));
      }
      line.erase(line.find_last_not_of(' ') + 1);
      picture += line + '\n';
    }
    return picture;
  }

 private:
  [[nodiscard]] std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y - bounds_.top) * static_cast<std::size_t>(bounds_.width()) +
           static_cast<std::size_t>(x - bounds_.left);
  }

  Rect bounds_;
  std::vector<Cell> cells_;
  SinkFaults faults_;
  Span run_{};
  bool is_open_ = false;
  std::uint64_t runs_ = 0;
};

static_assert(PixelSink<StrictSink>);

}  // namespace arcspan::test
