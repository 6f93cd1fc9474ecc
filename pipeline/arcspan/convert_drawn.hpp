// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

/// Copies a run of pixels of a row into another sink.
template <class From, PixelSink Target>
[[nodiscard]] constexpr Status convert_run(typename From::Cursor from, const Span& run, Target& target) {
  auto to = target.open(run);
  for (std::int32_t x = run.x; x < run.x + run.count; ++x, from.next(), to.next())
    to.write(encode_at<typename Target::Format>(From::decode(from.read()), x, run.y));
  return target.close(run);
}

/// Returns the reason why nothing can be converted, or kOk.
template <class Source, class Target>
[[nodiscard]] constexpr Status check_conversion(const Source& source, const DepthBuffer& depth,
                                                const Target& target) {
  if (const Status status = status_of(source); !ok(status)) return status;
  if (const Status status = status_of(target); !ok(status)) return status;
  if (!ok(depth.status())) return depth.status();
  if (source.bounds().empty()) return Status::kOk;
  if (!contains(target.bounds(), source.bounds())) return Status::kInvalidArgument;
  return contains(depth.bounds(), source.bounds()) ? Status::kOk : Status::kDepthMismatch;
}

}  // namespace detail

/// Copies what was drawn in one pixel format into a sink of another: the pixels of `source` whose depth is
/// not DepthBuffer::kFarthest. All other pixels of `target` stay. So a program draws in one format, for which
/// the pipeline is compiled, into a band and its depth buffer, and shows the picture in formats that are
/// known when it runs, over a background that is there already. All three represent the same picture, and
/// pixels keep their place in it. SinkPart cuts `source` to a rectangle.
///
/// A pixel becomes Target::Format::encode(Source::Format::decode(pixel)), or encode_dithered() of it if the
/// target's format dithers. From a source of 8 bits per channel (Rgb888, Xrgb8888, ...) this is the pixel
/// that drawing into `target` gives, except for one that is blended, because blending computes in the format.
/// Bits that the source does not store stay lost: after Rgb565 a target of 24 bits has 32 or 64 levels per
/// channel.
///
/// A surface that writes no depth (ReadOnlyDepth, or blended in a scene) is copied only where something
/// behind it wrote it, and ink and smoothed pixels outside of outlines likewise: smooth and ink outlines in
/// `target` afterwards. The target gets a run for every row of neighbouring pixels. Returns
///
///   kOk                all of them are converted
///   kInvalidArgument   source.bounds() are not within target.bounds(), though not empty
///   kDepthMismatch     source.bounds() are not within depth.bounds(), though not empty
///
/// or the status() of an argument, or the first status of the target that is not kOk, at which converting
/// ends. With kInvalidArgument, kDepthMismatch and the status() of an argument nothing is written.
template <SinkInMemory Source, PixelSink Target>
[[nodiscard]] constexpr Status convert_drawn(const Source& source, const DepthBuffer& depth, Target& target) {
  const Status possible = detail::check_conversion(source, depth, target);
  if (!ok(possible)) return possible;
  const Rect bounds = source.bounds();
  if (bounds.empty()) return Status::kOk;
  for (std::int32_t y = bounds.top; y < bounds.bottom; ++y) {
    const std::uint16_t* const depths = depth.row(y);
    std::int32_t x = bounds.left;
    while (x < bounds.right) {
      if (depths[x] == DepthBuffer::kFarthest) {
        ++x;
        continue;
      }
      const std::int32_t first = x;
      while (x < bounds.right && depths[x] != DepthBuffer::kFarthest) ++x;
      const Status status = detail::convert_run<typename Source::Format>(
          typename Source::Format::Cursor(source.row(y), first), {y, first, x - first}, target);
      if (!ok(status)) return status;
    }
  }
  return Status::kOk;
}

}  // namespace arcspan
