// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture_binary.hpp>

#include <arcspan_tools/command/runtime_model.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A core that forecasts are made for.
struct ForecastCore {
  const char* name;
  std::string_view weights;  ///< its key in docs/estimates.json
};
inline constexpr std::array<ForecastCore, 4> kForecastCores = {{{"Cortex-M0+", "mps2-an385-armv6m"},
                                                                {"Cortex-M3", "mps2-an385"},
                                                                {"Cortex-M4", "mps2-an385"},
                                                                {"RV32IMC", "riscv-virt"}}};

/// Instructions of a frame on each core; nothing where there are no figures.
using CoreFigures = std::array<std::optional<double>, kForecastCores.size()>;

/// What drawing a model will cost.
struct Forecast {
  struct Method {
    std::string name;
    CoreFigures instructions{};
    CoreFigures posing{};  ///< of these; 0 for a model that stands still
  };

  Size size;
  double mips = 0;           ///< million instructions per second
  std::size_t pictures = 0;  ///< of which the figures are the mean
  std::vector<Method> methods{};
  std::size_t frame_bytes = 0;  ///< of RAM: colours and depths
  std::size_t band_bytes = 0;   ///< both in bands of kBandRows
  std::size_t cache_bytes = 0;  ///< vertices of the largest part, by arc
  std::size_t kept_bytes = 0;   ///< vertices of all parts, which bands keep: each part has its own
  std::size_t row_bytes = 0;    ///< rows of all their triangles, for bands
  std::size_t pose_bytes = 0;   ///< nodes, joints and weights of morph targets
  std::size_t model_bytes = 0;  ///< of flash
  bool textured = false;        ///< a part has a texture
  bool outlined = false;        ///< it has neighbours: its outlines are smoothed
  bool borders = false;         ///< a texture does not repeat, which is not in the figures

  static constexpr std::int32_t kBandRows = 16;
};

/// A picture of which the cost is estimated.
struct ForecastPicture {
  FixedModel pose{};
  Scene scene{};
  std::string clip{};  ///< empty at rest
  double seconds = 0;
};

/// A model at a time of a clip, in seconds.
using Poser = std::function<FixedModel(const std::string& clip, double seconds)>;

/// Pictures of a model that fills them, at even steps of a turn and of the time of its clips.
[[nodiscard]] std::vector<ForecastPicture> forecast_pictures(const Poser& posed,
                                                             const std::vector<ClipLength>& clips, Size size);

/// Forecasts forecast_pictures() in rgb565 with depth and one light, and textures of `layout`. `model`
/// has its animation, if it moves.
[[nodiscard]] Forecast forecast(const FixedModel& model, std::size_t model_bytes, Size size, double mips,
                                const std::string& subject, TexelLayout layout);

}  // namespace arcspan::tools
