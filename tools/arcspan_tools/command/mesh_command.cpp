// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/mesh_report.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/command/texture_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/image/side_by_side.hpp>
#include <arcspan_tools/mesh/compile/animation_error.hpp>
#include <arcspan_tools/mesh/compile/make_animation.hpp>
#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <arcspan_tools/support/result_files.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <utility>

namespace arcspan::tools {
namespace {

struct MeshArguments {
  std::string model;
  std::string output;
  std::string name;
  std::string picture;
  std::string stats;
  std::string group;
  bool planes = false;
  bool outlines = false;
  bool for_c = false;
  std::int32_t toon_steps = 0;  ///< of the prepared materials, or 0
  bool textures = true;
  bool made_textures = false;  ///< the model has some
  bool moves = false;          ///< the model has a rig, and keeps it
  std::string texture;         ///< a picture for all parts, or none
  VertexColours colours = VertexColours::kMean;
  std::optional<PoseChoice> pose;
  ClipOptions clips;
  std::int32_t error_pixels = 240;
  bool forecast = false;
  Size forecast_size{240, 320};
  double cpu_mhz = 50;
  TextureOptions texture_options = default_model_texture_options();
  MeshLimits limits;
};

struct Made {
  MeshReport report;
  FixedModel model;
  ModelTextures textures;
};

/// The least side to which textures are shrunk before triangles are given up.
constexpr std::int32_t kLeastShrunkSide = 32;

/// Shrinks textures whose size was not asked for until the model, with all the triangles that --max-triangles
/// leaves, is within --max-bytes or they have the least side: half the texels cost a picture less than half
/// the triangles. Returns the options of the textures.
TextureOptions fitting_textures(const MeshArguments& arguments, CompiledOutput output, const Model& data,
                                const FixedModel& model) {
  TextureOptions options = arguments.texture_options;
  const std::optional<std::size_t> most = arguments.limits.max_bytes;
  const auto has_texture = [](const PartLook& look) { return look.material.texture != nullptr; };
  if (!most || options.size || std::ranges::none_of(model.looks, has_texture)) return options;
  MeshLimits triangles_only = arguments.limits;
  triangles_only.max_bytes.reset();
  const FixedModel whole = compile_model(
                               data, triangles_only, [](const FixedModel&) { return std::size_t{0}; },
                               arguments.model, [](std::size_t) {})
                               .model;
  const FixedModel measured = arguments.outlines ? with_neighbours(whole, arguments.model) : whole;
  ModelTextures textures = make_textures(whole, options);
  const auto fits = [&] { return model_bytes(output, measured, arguments.planes, textures) <= *most; };
  while (!fits() && options.most_side > kLeastShrunkSide) {
    options.most_side /= 2;
    textures = make_textures(whole, options);
  }
  return options;
}

/// The textures of the parts that simplification has left, of those of the whole model.
ModelTextures left_textures(const FixedModel& left, const Made& whole) {
  ModelTextures textures;
  std::set<std::size_t> known;
  for (std::size_t i = 0; i < whole.textures.of_part.size(); ++i) {
    const std::optional<std::size_t> texture = whole.textures.of_part[i];
    const bool is_left = std::ranges::find(left.looks, whole.model.looks[i]) != left.looks.end();
    if (is_left && texture && known.insert(*texture).second)
      textures.textures.push_back(whole.textures.textures[*texture]);
  }
  return textures;
}

/// The model with what of its rig is stored, if it has one.
FixedModel with_animation(FixedModel model, const MeshArguments& arguments) {
  if (model.rig == nullptr) return model;
  model.animation = std::make_shared<FixedAnimation>(make_animation(model, arguments.clips, arguments.model));
  return model;
}

/// Refuses what a model that moves cannot have; a C++ source for C holds it as it stands at rest.
void check_rig(const MeshArguments& arguments, CompiledOutput output, Model& model) {
  if (model.binary != nullptr) {
    warn(arguments.model,
         "its joints and clips are not written again, the model stands at rest (see --pose)");
    model = posed(model, PoseChoice{}, arguments.model);
  }
  if (model.rig == nullptr) return;
  if (arguments.for_c && output == CompiledOutput::kHeader) {
    warn(arguments.model,
         "its joints and clips are not in a source for C, the model stands at rest (a .h has them; see "
         "--pose)");
    model = posed(model, PoseChoice{}, arguments.model);
    return;
  }
  const std::string needs = "needs --pose with a model that moves: ";
  if (arguments.planes) throw Failure("--planes", needs + "planes do not");
  if (arguments.limits.crease_degrees)
    throw Failure("--crease", needs + "normals are made anew for one pose");
}

/// Warns of opacity that is left out: that of materials, and that of texels in a format without alpha.
void warn_of_opacity(const MeshArguments& arguments, const Model& model) {
  const auto warn_if = [&](const auto& is_lost, const char* what) {
    if (std::any_of(model.parts.begin(), model.parts.end(), is_lost)) warn(arguments.model, what);
  };
  warn_if([](const ModelPart& part) { return part.look.material.opacity < 1; },
          "the opacity of materials is not written");
  if (arguments.texture_options.format.layout != TexelLayout::kGray) return;
  warn_if(
      [](const ModelPart& part) {
        return part.look.material.texture != nullptr && part.look.material.alpha_mode != AlphaMode::kOpaque;
      },
      "the opacity of textures is not written: the format gray has none");
}

Made make(const MeshArguments& arguments, CompiledOutput output) {
  Model data = load_model(arguments.model, {}, arguments.texture, arguments.colours, arguments.pose);
  check_rig(arguments, output, data);
  if (!arguments.textures) remove_textures(data);
  warn_of_opacity(arguments, data);
  if (!arguments.group.empty()) data = select_parts(std::move(data), arguments.group, arguments.model);
  data = as_stored(data);
  Made made{{}, to_fixed(data), {}};
  const TextureOptions texture_options = fitting_textures(arguments, output, data, made.model);
  made.textures = make_textures(made.model, texture_options);
  const BytesOf bytes_of = [output, &arguments, &made](const FixedModel& model) {
    FixedModel whole = with_animation(model, arguments);
    if (arguments.outlines) {
      // The bytes of neighbours depend on the order that the triangles will have.
      for (FixedMesh& mesh : whole.meshes) mesh = ordered(mesh);
      whole = with_neighbours(std::move(whole), arguments.model);
    }
    return model_bytes(output, whole, arguments.planes, left_textures(model, made));
  };
  MeshReport& report = made.report;
  report.model = arguments.model;
  report.output = arguments.output;
  report.model_vertices = data.vertex_count();
  report.model_triangles = data.triangle_count();
  report.model_bytes = bytes_of(made.model);
  report.model_extent = made.model.meshes[0].unit * 65534;
  report.dropped_faces = data.dropped_faces;
  report.crease_degrees = data.crease_degrees;
  Progress progress("simplifying", 0);
  report.compiled = compile_model(data, arguments.limits, bytes_of, arguments.model,
                                  [&progress](std::size_t tried) { progress.show(tried); });
  for (FixedMesh& mesh : report.compiled.model.meshes) {
    if (arguments.planes) mesh = with_planes(std::move(mesh), arguments.model);
    if (arguments.outlines) mesh = with_neighbours(std::move(mesh), arguments.model);
  }
  // Simplification may have left out parts.
  made.textures = make_textures(report.compiled.model, texture_options);
  report.compiled.model = with_animation(report.compiled.model, arguments);
  if (report.compiled.model.rig != nullptr) report.animation = animation_error(report.compiled.model);
  report.error_pixels = arguments.error_pixels;
  report.bytes = model_bytes(output, report.compiled.model, arguments.planes, made.textures);
  report.shares = byte_shares(output, report.compiled.model, made.textures);
  report.shrunk_textures = texture_options.most_side < arguments.texture_options.most_side;
  report.textures = made.textures.textures;
  report.figures = figures_of(report.compiled.model);
#ifdef ARCSPAN_HAS_ESTIMATES
  if (arguments.forecast)
    report.forecast =
        forecast(with_made_textures(report.compiled.model, made.textures), report.bytes,
                 arguments.forecast_size, arguments.cpu_mhz, arguments.model, texture_options.format.layout);
#endif
  return made;
}

/// Both models from where the model as it was fills the picture.
Image before_and_after(const Made& made, const std::string& subject) {
  Scene scene;
  const Camera camera = place_camera(scene.camera, made.model, scene.size);
  scene.camera.eye = camera.eye;
  scene.camera.target = camera.target;
  const Renderer& renderer = find_renderer("arc", "rgb888", false);
  const auto drawn = [&](const FixedModel& model) {
    return renderer.render(make_job(scene, model, subject), [](std::size_t) {}).image;
  };
  return side_by_side(drawn(made.model), drawn(made.report.compiled.model));
}

std::string name_of(const MeshArguments& arguments) {
  if (!arguments.name.empty()) return arguments.name;
  const std::filesystem::path from =
      is_standard_output(arguments.output) ? arguments.model : arguments.output;
  return identifier(from.stem().string());
}

/// The compiled model in its form.
std::string compiled_file(const MeshArguments& arguments, CompiledOutput output, const Made& made) {
  const FixedModel& model = made.report.compiled.model;
  const bool is_binary = output == CompiledOutput::kBinary;
  if (is_binary && !arguments.for_c) return model_binary_file(model, made.textures);
  const std::string name = name_of(arguments);
  const std::string origin = std::filesystem::path(arguments.model).filename().string();
  if (!arguments.for_c) return model_header(model, name, origin, made.textures);
  if (is_binary) return model_c_header(model, name, origin, made.textures);
  return model_c_source(model, name, origin, made.textures, arguments.toon_steps);
}

void run_mesh(MeshArguments& arguments) {
  const CompiledOutput output = compiled_mesh_output(arguments.output, arguments.for_c);
  check_results({arguments.output, arguments.picture, arguments.stats}, {arguments.model, arguments.texture});
  if (!arguments.picture.empty()) (void)image_format(arguments.picture);
  const Made made = make(arguments, output);
  const MeshReport& report = made.report;
  arguments.made_textures = !report.textures.empty();
  arguments.moves = report.animation.has_value();
  std::vector<ResultFile> results = {{arguments.output, compiled_file(arguments, output, made)}};
  if (!arguments.picture.empty()) {
    const Image picture = before_and_after(made, arguments.model);
    results.push_back({arguments.picture, encode_image(picture, image_format(arguments.picture))});
  }
  if (!arguments.stats.empty()) results.push_back({arguments.stats, to_json(report)});
  write_results(results, to_text(report));
  for (const std::string& caution : warnings(report)) warn(arguments.model, caution);
}

/// `DEGREES,SHARE`.
std::optional<ClipOptions> parse_clip_tolerance(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const std::optional<double> degrees = parse_number(text.substr(0, comma));
  const std::optional<double> share = parse_number(text.substr(comma + 1));
  const auto fits = [](const std::optional<double>& v, double most) { return v && *v >= 0 && *v <= most; };
  if (!fits(degrees, 90) || !fits(share, 1)) return std::nullopt;
  return ClipOptions{*degrees, *share};
}

void add_clip_tolerance(CLI::App& mesh, ClipOptions& clips) {
  add_parsed<ClipOptions>(
      mesh, "--clip-tolerance", "DEGREES,SHARE",
      "leave out keys of clips as long as each node, on its own, is within so many degrees and this share of "
      "the model's extent (default: the file's keys); the report says what they add up to",
      "two numbers, 0...90 and 0...1", parse_clip_tolerance, [&clips](const ClipOptions& o) { clips = o; });
}

void add_limits(CLI::App& mesh, MeshLimits& limits) {
  const auto parse_count = [](const std::string& text) -> std::optional<std::size_t> {
    const std::optional<std::int64_t> value = parse_integer(text);
    if (!value || *value < 1 || *value > 1'000'000'000) return std::nullopt;
    return static_cast<std::size_t>(*value);
  };
  add_parsed<std::size_t>(mesh, "--max-triangles", "N", "simplify until there are no more",
                          "an integer 1...1000000000", parse_count,
                          [&limits](std::size_t n) { limits.max_triangles = n; });
  add_parsed<std::size_t>(mesh, "--max-bytes", "N",
                          "shrink textures to as few as 32x32 texels, then simplify, until it takes no more",
                          "an integer 1...1000000000", parse_count,
                          [&limits](std::size_t n) { limits.max_bytes = n; });
  add_crease(mesh, limits.crease_degrees);
}

#ifdef ARCSPAN_HAS_ESTIMATES
void add_forecast(CLI::App& mesh, MeshArguments& arguments) {
  mesh.add_flag(
      "--forecast", arguments.forecast,
      "estimate instructions and frames per second by flat, Gouraud and arc shading on a Cortex-M0+, M3, "
      "M4 and RV32, by arc in bands of 16 rows, too, and memory");
  add_parsed<Size>(
      mesh, "--size", "WxH", "picture size of the forecast, each 1...2048 (default 240x320)",
      "WxH with each 1...2048",
      [](const std::string& text) {
        const std::optional<Size> size = parse_size(text);
        return size && size->width <= kMostRenderedSide && size->height <= kMostRenderedSide ? size
                                                                                             : std::nullopt;
      },
      [&arguments](Size size) { arguments.forecast_size = size; });
  add_number(mesh, "--cpu-mhz", "million instructions a second of the forecast's processors", 0.1, 10000,
             arguments.cpu_mhz);
}
#else
void add_forecast(CLI::App&, MeshArguments&) {}
#endif

}  // namespace

void add_mesh_command(CLI::App& app) {
  auto arguments = std::make_shared<MeshArguments>();
  CLI::App* mesh = app.add_subcommand("mesh", "Compile a model into a mesh for flash");
  mesh->add_option("MODEL", arguments->model,
                   "an .obj, .gltf, .glb, .fbx, .dae, .3ds, .ply, .stl, .off or .bin file, or sphere:32x16, "
                   "torus:48x24")
      ->required();
  mesh->add_option("-o,--output", arguments->output,
                   "a header of constexpr arrays (.hpp, .h) or a binary (.bin), with all parts and their "
                   "materials; hpp:- and bin:- are standard output")
      ->required();
  add_pose(*mesh, arguments->pose);
  add_clip_tolerance(*mesh, arguments->clips);
  add_integer(*mesh, "--error-pixels", "N",
              "largest extent of the model in the picture for which the error of clips is told (default 240)",
              1, kMostRenderedSide, arguments->error_pixels);
  add_limits(*mesh, arguments->limits);
  mesh->add_option("--name", arguments->name,
                   "the header's namespace, or the model for C (default: from the file's name)")
      ->check([](const std::string& text) {
        return is_identifier(text) ? "" : "'" + text + "' cannot name a namespace";
      });
  mesh->add_option("--group", arguments->group,
                   "only the parts of this name: an object, a group (g) or a mesh of the file");
  mesh->add_flag(
      "--planes", arguments->planes,
      "the triangles' planes too, 4 bytes each: backs are then culled before they are transformed");
  mesh->add_flag("--outlines", arguments->outlines,
                 "the triangles' neighbours too, about 2.6 bytes each, by which programs smooth outlines");
  mesh->add_flag("--curved-outlines", arguments->limits.curves,
                 "the same, and room in the positions for all curves of CurvedOutlines");
  add_texture(*mesh, arguments->texture);
  add_texture_format(*mesh, "--texture-format", arguments->texture_options.format);
  add_texture_size(*mesh, "--texture-size", ", at most 128", arguments->texture_options.size);
  add_texture_levels(*mesh, "--texture-levels", arguments->texture_options.levels);
  mesh->add_flag_callback(
      "--no-textures", [arguments] { arguments->textures = false; }, "leave out textures and texture points");
  mesh->add_flag_callback(
      "--vertex-colours", [arguments] { arguments->colours = VertexColours::kKept; },
      "write vertex colours, 3 bytes each, for VertexColoured (default: parts in the triangles' mean "
      "colours)");
  mesh->add_flag(
      "--c", arguments->for_c,
      "for arcspan.h: a C++ source (.cpp) with the model and its prepared materials, in C extern const "
      "arcspan_model NAME; or a C header (.h) with the binary, also of a model that moves, as NAME");
  add_integer(*mesh, "--toon", "STEPS",
              "of a source by --c: materials for light in 2...16 steps and hard highlights", 2, 16,
              arguments->toon_steps);
  add_forecast(*mesh, *arguments);
  mesh->add_option("--picture", arguments->picture, "draw the model before and after, side by side");
  mesh->add_option("--stats", arguments->stats, "write the printed figures as JSON");
  mesh->footer(
      "Examples:\n"
      "  arcspan mesh bunny.obj -o bunny.hpp --max-bytes 16384 --picture bunny.png\n"
      "  arcspan mesh part.stl -o part.bin --crease 40 --max-triangles 800\n"
      "  arcspan mesh man.glb -o man.bin --clip-tolerance 0.1,0.0002\n"
      "  arcspan mesh man.glb -o standing.bin --pose rest\n"
      "  arcspan mesh man.glb -o man.bin --forecast --size 240x240 --cpu-mhz 64\n"
      "  arcspan mesh car.glb -o wheels.hpp --group wheels\n"
      "  arcspan mesh spider.obj -o spider.bin --texture-format pal4 --texture-size 64\n"
      "  arcspan mesh torus:24x12 -o bin:- | xxd -i > torus.inc");
  mesh->callback([mesh, arguments] {
    if (!arguments->textures && !arguments->texture.empty())
      throw CLI::ValidationError("--texture", "excludes --no-textures");
    if (mesh->count("--name") != 0 && !arguments->for_c &&
        compiled_mesh_output(arguments->output, arguments->for_c) == CompiledOutput::kBinary)
      throw CLI::ValidationError("--name", "is of headers, not of binaries");
    if (arguments->toon_steps != 0 &&
        (!arguments->for_c ||
         compiled_mesh_output(arguments->output, arguments->for_c) == CompiledOutput::kBinary))
      throw CLI::ValidationError("--toon", "needs --c and a source: other models have no prepared materials");
    for (const char* option : {"--size", "--cpu-mhz"}) {
      if (!arguments->forecast && mesh->get_option_no_throw(option) != nullptr && mesh->count(option) != 0)
        throw CLI::ValidationError(option, "is of --forecast");
    }
    if (arguments->limits.curves) arguments->outlines = true;
    run_mesh(*arguments);
    for (const char* option : {"--clip-tolerance", "--error-pixels"}) {
      if (!arguments->moves && mesh->count(option) != 0)
        warn(option, "has no effect: the model stands still");
    }
    if (!arguments->made_textures) {
      for (const char* option : {"--texture-format", "--texture-size", "--texture-levels"}) {
        if (mesh->count(option) != 0) warn(option, "has no effect: the model has no textures");
      }
    }
  });
}

}  // namespace arcspan::tools
