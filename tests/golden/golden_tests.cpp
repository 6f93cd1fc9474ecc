// SPDX-License-Identifier: MIT
// golden_tests MESH HASHES REFERENCES FOUND [--update]
//
// Draws MESH (a .fixed file or a generated mesh) in every golden scene, pixel format and some band heights
// and compares: the pixels' hashes with the file HASHES, and each format with the encoding of the picture in
// 8 bits a channel. Where a picture differs, it and its difference from the one in the folder REFERENCES are
// written to the folder FOUND. With --update the hashes (on standard output) and the reference pictures are
// made instead.
#include <arcspan/pixel/pixel_format_list.hpp>

#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <tests/golden/fixed_file.hpp>
#include <tests/golden/golden_scenes.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>

namespace arcspan::test {
namespace {

using tools::Image;
using tools::PixelChoice;
using tools::Renderer;

/// FNV-1a over size and pixels.
std::uint64_t hash(const Image& image) {
  std::uint64_t h = 0xcbf29ce484222325u;
  const auto add = [&h](unsigned byte) { h = (h ^ byte) * 0x100000001b3u; };
  for (const std::int32_t size : {image.width, image.height}) {
    add(static_cast<unsigned>(size) & 255u);
    add(static_cast<unsigned>(size) >> 8);
  }
  for (const Rgb8& p : image.pixels) {
    add(p.r);
    add(p.g);
    add(p.b);
  }
  return h;
}

std::string hex(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

struct Goldens {
  std::map<std::string, std::string> hashes;
  std::filesystem::path references;
  std::filesystem::path found;
  bool update = false;
  int compared = 0;
  int wrong = 0;

  void read_hashes(const std::string& path) {
    std::ifstream in(path);
    for (std::string name, value; in >> value >> name;) hashes[name] = value;
  }

  void compare(const std::string& name, const Image& image) {
    if (update) return static_cast<void>(std::printf("%s %s\n", hex(hash(image)).c_str(), name.c_str()));
    ++compared;
    if (hashes.count(name) == 0 || hashes[name] != hex(hash(image)))
      complain(name, image, "is not the golden one");
  }

  void complain(const std::string& name, const Image& image, const char* what) {
    ++wrong;
    std::string flat = name;
    for (char& c : flat) c = c == '/' || c == ':' ? '_' : c;
    const std::filesystem::path picture = found / (flat + ".png");
    tools::write_image(image, picture);
    std::printf("%s: the picture %s: %s", name.c_str(), what, picture.c_str());
    const std::filesystem::path reference = reference_of(name);
    if (std::filesystem::exists(reference)) {
      const Image expected = tools::read_image(reference);
      const std::filesystem::path difference = found / (flat + "-difference.png");
      if (expected.width == image.width && expected.height == image.height) {
        tools::write_image(tools::difference_picture(expected, image), difference);
        std::printf(", difference from %s: %s", reference.c_str(), difference.c_str());
      }
    }
    std::printf("\n");
  }

  /// Of "mesh/scene/format": one for all formats.
  [[nodiscard]] std::filesystem::path reference_of(const std::string& name) const {
    std::string flat = name.substr(0, name.rfind('/'));
    for (char& c : flat) c = c == '/' || c == ':' ? '_' : c;
    return references / (flat + ".png");
  }
};

template <class Format>
Image encoded(const Image& image) {
  Image out(image.width, image.height);
  for (std::int32_t y = 0; y < image.height; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) {
      const Rgb8 p = image.at(x, y);
      out.at(x, y) = Format::decode(encode_at<Format>(PackedRgb::of(4u * p.r, 4u * p.g, 4u * p.b), x, y));
    }
  }
  return out;
}

Image encoded(const Image& image, const PixelChoice& pixels) {
#define ARCSPAN_ENCODE_IF_CHOSEN(name, Format)                                         \
  if (pixels.format == #name) {                                                        \
    return pixels.dithers ? encoded<Dithered<Format>>(image) : encoded<Format>(image); \
  }
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_ENCODE_IF_CHOSEN)
#undef ARCSPAN_ENCODE_IF_CHOSEN
  return {};
}

bool same_where_drawn(const Image& a, const Image& b, const Image& full, Rgb8 background) {
  // The background is cleared, not drawn, so it is not dithered.
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (full.pixels[i] != background && a.pixels[i] != b.pixels[i]) return false;
  }
  return true;
}

void check_scene(Goldens& goldens, const std::string& mesh_name, const tools::FixedMesh& mesh,
                 const GoldenScene& golden) {
  if (golden.sample && mesh_name != "sphere:8x4" && mesh_name != "torus:48x24") return;
  const auto quiet = [](std::size_t) {};
  tools::RenderJob job = tools::make_job(golden.scene, mesh, mesh_name);
  job.counts = false;
  const Image full = tools::find_renderer(golden.shading, "rgb888", false).render(job, quiet).image;
  const std::string prefix = mesh_name + "/" + golden.name + "/";
  if (goldens.update) tools::write_image(full, goldens.reference_of(prefix));
  for (const Renderer& renderer : tools::renderers()) {
    if (renderer.shading != golden.shading) continue;
    const PixelChoice& pixels = renderer.pixels;
    if (golden.sample && pixels.format != "rgb888") continue;
#ifdef ARCSPAN_FEW_GOLDENS
    // Behind virtual calls the code of a format depends neither on the mesh nor on the shading.
    const bool in_all_formats = mesh_name == "sphere:8x4" && golden.shading == "arc";
    if (!goldens.update && !in_all_formats && pixels.format != "rgb565") continue;
#endif
    const std::string name = prefix + std::string(pixels.format) + (pixels.dithers ? "-dithered" : "");
    job.band_rows = golden.scene.size.height;
    const Image image = renderer.render(job, quiet).image;
    goldens.compare(name, image);
    if (!same_where_drawn(image, encoded(full, pixels), full, job.background)) {
      goldens.complain(name, image, "is not the encoding of the one in 8 bits a channel");
    }
    job.band_rows = pixels.dithers ? 1 : 17;
    if (renderer.render(job, quiet).image != image)
      goldens.complain(name, image, "changes when drawn in bands");
  }
}

int run(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: golden_tests MESH HASHES REFERENCES FOUND [--update]\n");
    return 2;
  }
  const std::string mesh_argument = argv[1];
  Goldens goldens;
  goldens.read_hashes(argv[2]);
  goldens.references = argv[3];
  goldens.found = argv[4];
  goldens.update = argc > 5 && std::string(argv[5]) == "--update";
  std::filesystem::create_directories(goldens.found);
  const auto generated = tools::parse_generated_mesh(mesh_argument);
  const tools::FixedMesh mesh =
      generated ? tools::to_fixed(tools::generate(*generated)) : read_fixed(mesh_argument);
  const std::string name = generated ? mesh_argument : std::filesystem::path(mesh_argument).stem().string();
  for (const GoldenScene& scene : golden_scenes()) check_scene(goldens, name, mesh, scene);
  if (!goldens.update)
    std::printf("%s: %d pictures compared, %d wrong\n", name.c_str(), goldens.compared, goldens.wrong);
  return goldens.wrong == 0 && (goldens.update || goldens.compared > 0) ? 0 : 1;
}

}  // namespace
}  // namespace arcspan::test

int main(int argc, char** argv) {
  try {
    return arcspan::test::run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "golden_tests: %s\n", e.what());
    return 1;
  }
}
