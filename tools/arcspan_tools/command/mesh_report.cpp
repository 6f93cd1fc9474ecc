// SPDX-License-Identifier: MIT
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <arcspan_tools/command/forecast_report.hpp>
#include <arcspan_tools/command/mesh_report.hpp>
#include <arcspan_tools/command/render_report.hpp>
#include <arcspan_tools/mesh/compile/mirroring_clips.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/text.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace arcspan::tools {
namespace {

std::string position_text(const ObjectPosition& p) { return formatted("(%d, %d, %d)", p.x, p.y, p.z); }

std::size_t triangles(const MeshReport& r) { return r.compiled.model.triangle_count(); }

bool has_planes(const MeshReport& r) { return !r.compiled.model.meshes[0].planes.empty(); }

bool has_neighbours(const MeshReport& r) { return !r.compiled.model.meshes[0].neighbours.empty(); }

/// 8 or 16; 0 if parts differ.
int index_bits(const MeshReport& r) {
  const std::vector<FixedMesh>& meshes = r.compiled.model.meshes;
  const auto is_short = [](const FixedMesh& mesh) { return fits_indices8(mesh.positions.size()); };
  if (std::all_of(meshes.begin(), meshes.end(), is_short)) return 8;
  return std::none_of(meshes.begin(), meshes.end(), is_short) ? 16 : 0;
}

std::string index_text(const MeshReport& r) {
  const int bits = index_bits(r);
  return bits == 0 ? "8-bit and 16-bit indices" : std::to_string(bits) + "-bit indices";
}

std::string coefficients_text(const ChannelCoefficients& c) {
  const auto value = [](Coefficient v) { return std::ldexp(v.raw(), -Coefficient::kFraction); };
  return formatted("%.2f,%.2f,%.2f", value(c.r), value(c.g), value(c.b));
}

/// A line for each part of a model that is more than a plain mesh.
std::string parts_text(const MeshReport& r) {
  const FixedModel& model = r.compiled.model;
  if (is_plain_mesh(model)) return {};
  constexpr std::size_t kMostPartsListed = 40;
  const std::vector<std::string> names = part_names(model);
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostPartsListed); ++i) {
    const Material material = material_of(model.looks[i]);
    text +=
        "  " + printable(names[i]) +
        formatted(": %zu vertices, %zu triangles, diffuse %s, specular %s, shininess %d%s\n",
                  model.meshes[i].positions.size(), model.meshes[i].indices.size() / 3,
                  coefficients_text(material.diffuse).c_str(), coefficients_text(material.specular).c_str(),
                  material.shininess, model.looks[i].material.two_sided ? ", two-sided" : "");
  }
  if (names.size() > kMostPartsListed)
    text += formatted("  and %zu more parts\n", names.size() - kMostPartsListed);
  return text;
}

std::string textures_text(const MeshReport& r) {
  std::string text;
  for (std::size_t i = 0; i < r.textures.size(); ++i) {
    const MadeTexture& texture = r.textures[i];
    text += formatted("  texture %zu: %ux%u texels, %s, levels: %d, %zu bytes\n", i + 1,
                      1u << texture.size.width_bits, 1u << texture.size.height_bits, texture.format.name,
                      texture.size.levels, texture.bytes());
    if (texture.left_out > 0) text += "    " + left_out_text(texture);
  }
  return text;
}

/// Keys of all channels of a clip.
std::size_t key_count(const FixedClip& clip) {
  std::size_t sum = 0;
  for (const FixedChannel& channel : clip.channels) sum += channel.times.size();
  return sum;
}

std::size_t joint_count(const FixedAnimation& animation) {
  std::size_t sum = 0;
  for (const FixedSkin& skin : animation.skins) sum += skin.size();
  return sum;
}

/// How many vertices follow 1, 2, 3 and 4 joints.
std::array<std::size_t, kMostWeights> influence_counts(const FixedAnimation& animation) {
  std::array<std::size_t, kMostWeights> counts{};
  for (const FixedPartMotion& part : animation.parts) {
    for (const FixedWeights& weights : part.weights) ++counts[weights.count - 1];
  }
  return counts;
}

std::size_t morph_target_count(const FixedAnimation& animation) {
  std::size_t sum = 0;
  for (const FixedPartMotion& part : animation.parts) sum += part.morph ? part.morph->weights.size() : 0;
  return sum;
}

/// The share of the extent by which a vertex is off.
double error_share(const MeshReport& r) { return r.animation->position / 65534; }

std::string animation_text(const MeshReport& r) {
  if (!r.animation) return {};
  const FixedAnimation& animation = *r.compiled.model.animation;
  const auto counts = influence_counts(animation);
  std::string text = formatted("moves: %zu nodes, %zu joints, %zu morph targets", animation.nodes.size(),
                               joint_count(animation), morph_target_count(animation));
  text += formatted("; vertices with 1, 2, 3 and 4 weights: %zu, %zu, %zu, %zu\n", counts[0], counts[1],
                    counts[2], counts[3]);
  for (const FixedClip& clip : animation.clips) {
    text += "  clip " + printable(clip.name) +
            formatted(": %g s, %zu channels, %zu keys\n", clip.duration / 1e6, clip.channels.size(),
                      key_count(clip));
  }
  const std::string where = r.animation->clip.empty() ? "at rest"
                                                      : "clip " + printable(r.animation->clip) +
                                                            formatted(" at %.3f s", r.animation->seconds);
  return text +
         formatted("error of what is stored: %.3g/2048 of the extent, that is %.3g of %d pixels (",
                   2048 * error_share(r), r.error_pixels * error_share(r), r.error_pixels) +
         where + formatted("), normals %.3g degrees\n", r.animation->normal_degrees);
}

nlohmann::ordered_json animation_json(const MeshReport& r) {
  const FixedAnimation& animation = *r.compiled.model.animation;
  nlohmann::ordered_json clips = nlohmann::ordered_json::array();
  for (const FixedClip& clip : animation.clips) {
    clips.push_back({{"name", clip.name},
                     {"seconds", clip.duration / 1e6},
                     {"channels", clip.channels.size()},
                     {"keys", key_count(clip)}});
  }
  return {{"nodes", animation.nodes.size()},
          {"joints", joint_count(animation)},
          {"morph_targets", morph_target_count(animation)},
          {"vertices_by_weights", influence_counts(animation)},
          {"clips", clips},
          {"error",
           {{"extent", error_share(r)},
            {"pixels", r.error_pixels * error_share(r)},
            {"of_pixels", r.error_pixels},
            {"normal_degrees", r.animation->normal_degrees}}}};
}

std::string shares_text(const MeshReport& r) {
  std::string text;
  for (const ByteShare& share : r.shares) {
    if (share.bytes > 0)
      text += formatted("%s%zu %s", text.empty() ? "bytes: " : ", ", share.bytes, share.name);
  }
  return text + "\n";
}

/// What drawing needs besides the model, for a picture of 320x240.
struct DrawingRam {
  std::size_t cache = 0;  ///< a vertex of `arc` with one light, for each vertex of the largest part
  std::size_t frame = 320 * 240 * sizeof(Rgb565::Word);
  std::size_t depth = 320 * 240 * sizeof(std::uint16_t);
  static constexpr std::size_t kBandRows = 8;

  [[nodiscard]] std::size_t band() const { return (frame + depth) / (240 / kBandRows); }
};

DrawingRam drawing_ram(const MeshReport& r) {
  using Method = Arc<Illumination<1, Highlight::kBlinn>>;
  using Mapped = Textured<Method, Palette8Texels<OpaqueColour>>;
  std::size_t most = 0;
  for (const FixedMesh& mesh : r.compiled.model.meshes) most = std::max(most, mesh.positions.size());
  DrawingRam ram;
  ram.cache = most * (r.textures.empty() ? sizeof(CachedVertex<Method>) : sizeof(CachedVertex<Mapped>));
  return ram;
}

std::string ram_text(const MeshReport& r) {
  const DrawingRam ram = drawing_ram(r);
  return formatted(
      "RAM to draw it: %zu bytes of vertices with arc (none without a cache), and at 320x240 in rgb565 %zu "
      "of "
      "colours and %zu of depths, or %zu of both in bands of %zu rows\n",
      ram.cache, ram.frame, ram.depth, ram.band(), DrawingRam::kBandRows);
}

nlohmann::ordered_json shares_json(const MeshReport& r) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const ByteShare& share : r.shares) all[share.name] = share.bytes;
  return all;
}

nlohmann::ordered_json ram_json(const MeshReport& r) {
  const DrawingRam ram = drawing_ram(r);
  return {{"vertices", ram.cache}, {"colours", ram.frame}, {"depths", ram.depth}, {"band", ram.band()}};
}

nlohmann::ordered_json textures_json(const MeshReport& r) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const MadeTexture& texture : r.textures) {
    all.push_back({{"width", 1u << texture.size.width_bits},
                   {"height", 1u << texture.size.height_bits},
                   {"format", texture.format.name},
                   {"levels", texture.size.levels},
                   {"levels_left_out", texture.left_out},
                   {"bytes", texture.bytes()}});
  }
  return all;
}

nlohmann::ordered_json json_channels(const ChannelCoefficients& c) {
  return {c.r.raw(), c.g.raw(), c.b.raw()};
}

nlohmann::ordered_json parts_json(const FixedModel& model) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const std::vector<std::string> names = part_names(model);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Material material = material_of(model.looks[i]);
    all.push_back({{"name", names[i]},
                   {"vertices", model.meshes[i].positions.size()},
                   {"triangles", model.meshes[i].indices.size() / 3},
                   {"ambient", json_channels(material.ambient)},
                   {"diffuse", json_channels(material.diffuse)},
                   {"specular", json_channels(material.specular)},
                   {"shininess", material.shininess},
                   {"two_sided", model.looks[i].material.two_sided}});
  }
  return all;
}

nlohmann::ordered_json corner(const ObjectPosition& p) { return {p.x, p.y, p.z}; }

/// A device has one order of the corners of a triangle, so that a mirrored one shows its back.
void add_mirroring_clips(const Rig& rig, std::vector<std::string>& lines) {
  for (const RigClip& clip : rig.clips) {
    const std::optional<std::size_t> node = mirrored_node(rig, clip);
    if (!node) continue;
    lines.push_back("the clip " + in_quotes(clip.name) + " mirrors the node " +
                    in_quotes(rig.nodes[*node].name) + ", whose triangles show their backs then");
  }
}

}  // namespace

std::string to_text(const MeshReport& r) {
  const FixedModel& model = r.compiled.model;
  std::string text = printable(r.model) + formatted(": %zu vertices, %zu triangles, %zu bytes",
                                                    r.model_vertices, r.model_triangles, r.model_bytes);
  if (r.dropped_faces > 0) text += formatted(", %zu faces without area left out", r.dropped_faces);
  text += crease_text(r.crease_degrees) + "\n" + printable(r.output) +
          formatted(": %zu vertices, %zu triangles, %zu bytes, %s%s%s", model.vertex_count(), triangles(r),
                    r.bytes, index_text(r).c_str(), has_planes(r) ? ", planes" : "",
                    has_neighbours(r) ? ", neighbours" : "");
  if (model.meshes.size() > 1) text += formatted(", %zu parts", model.meshes.size());
  text += "\n" + parts_text(r) + textures_text(r) + animation_text(r);
  if (r.shrunk_textures) text += "textures: shrunk to keep --max-bytes\n";
  text += shares_text(r) + ram_text(r);
  text += std::string("simplification: ") + to_string(r.compiled.how);
  if (r.compiled.how != Simplification::kNone) {
    text += formatted(", surface moved by about %.3g (%.2f %% of the extent)", r.compiled.error,
                      100 * r.compiled.error / r.model_extent);
  }
  text += "\nbounds: " + position_text(r.figures.bounds.low) + " ... " +
          position_text(r.figures.bounds.high) +
          formatted(", one step is %.6g of the model's units\n", model.meshes[0].unit);
  text += formatted("vertex cache of 16: %.2f misses per triangle, %.2f before\n", r.compiled.cache_misses,
                    r.compiled.cache_misses_before);
  text += formatted("widest normal angle of a triangle: %.1f degrees; %zu of %zu triangles above 60\n",
                    r.figures.widest_angle_degrees, r.figures.wide_triangles, triangles(r));
  if (r.forecast) text += to_text(*r.forecast);
  return text;
}

std::string to_json(const MeshReport& r) {
  const FixedMesh& mesh = r.compiled.model.meshes[0];
  nlohmann::ordered_json json = {
      {"model",
       {{"name", r.model},
        {"vertices", r.model_vertices},
        {"triangles", r.model_triangles},
        {"bytes", r.model_bytes},
        {"dropped_faces", r.dropped_faces},
        {"crease_degrees", crease_json(r.crease_degrees)}}},
      {"mesh",
       {{"file", r.output},
        {"vertices", r.compiled.model.vertex_count()},
        {"triangles", triangles(r)},
        {"bytes", r.bytes},
        {"bytes_of", shares_json(r)},
        {"index_bits", index_bits(r)},
        {"planes", has_planes(r)},
        {"neighbours", has_neighbours(r)},
        {"low", corner(r.figures.bounds.low)},
        {"high", corner(r.figures.bounds.high)},
        {"unit", mesh.unit},
        {"centre", {mesh.centre.x, mesh.centre.y, mesh.centre.z}}}},
      {"parts", parts_json(r.compiled.model)},
      {"textures", textures_json(r)},
      {"ram_at_320x240", ram_json(r)},
      {"simplification", {{"method", to_string(r.compiled.how)}, {"error", r.compiled.error}}},
      {"cache_misses_per_triangle",
       {{"before", r.compiled.cache_misses_before}, {"after", r.compiled.cache_misses}}},
      {"widest_normal_angle_degrees", r.figures.widest_angle_degrees},
      {"triangles_above_60_degrees", r.figures.wide_triangles},
  };
  if (r.animation) json["animation"] = animation_json(r);
  if (r.forecast) json["forecast"] = to_json(*r.forecast);
  // Names of files may be any bytes.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::vector<std::string> warnings(const MeshReport& r) {
  std::vector<std::string> lines;
  if (r.figures.wide_triangles > 0) {
    lines.push_back(formatted(
        "%zu of %zu triangles have normals more than 60 degrees apart, which makes them look bent (keep more "
        "triangles, or more edges sharp by --crease 60 or a smaller angle)",
        r.figures.wide_triangles, triangles(r)));
  }
  if (r.compiled.model.rig != nullptr) add_mirroring_clips(*r.compiled.model.rig, lines);
  const auto& animation = r.compiled.model.animation;
  if (animation != nullptr && !animation->still_clips.empty()) {
    lines.push_back(formatted("clips that move nothing of the model are left out (%zu): ",
                              animation->still_clips.size()) +
                    in_quotes(animation->still_clips[0]));
  }
  if (animation != nullptr && !animation->cut_names.empty()) {
    lines.push_back(
        formatted("names of clips and nodes are cut after 31 bytes (%zu): ", animation->cut_names.size()) +
        in_quotes(animation->cut_names[0]));
  }
  return lines;
}

}  // namespace arcspan::tools
