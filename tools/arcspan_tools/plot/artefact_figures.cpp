// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/artefacts.hpp>
#include <arcspan_tools/plot/figure_list.hpp>

namespace arcspan::tools {
namespace {

constexpr double kApart = 60;

Figure row_figure(const ArtefactScene& scene, const char* title) {
  Figure figure;
  figure.title = title;
  figure.x_label = "column of the picture's middle row";
  figure.y_label = "brightness, steps of 255";
  figure.curves.push_back({"reference (Phong, double)", scene.middle_row(ReferenceKind::kPhong)});
  for (const ShadingRenderer& renderer : shading_renderers()) {
    const std::string shading(renderer.shading);
    figure.curves.push_back({shading, scene.middle_row(shading)});
  }
  return figure;
}

template <class Shading>
Curve rotation_curve(const std::string& label, const Shading& shading) {
  Curve curve;
  curve.label = label;
  for (int turn = 0; turn < 360; turn += 5) {
    curve.points.emplace_back(turn, ArtefactScene::turned(kApart, turn).middle(shading));
  }
  return curve;
}

template <class Shading>
Curve flicker_curve(const std::string& label, const Shading& shading) {
  Curve curve;
  curve.label = label;
  for (int turn = 0; turn <= 60; ++turn) {
    curve.points.emplace_back(turn, peak(ArtefactScene::turning_sphere(turn).picture(shading)));
  }
  return curve;
}

}  // namespace

Figure highlight_figure() {
  return row_figure(ArtefactScene::highlight(), "A highlight inside a triangle (n = 64)");
}

Figure mach_figure() {
  return row_figure(ArtefactScene::fold(), "Across the edge between two triangles (diffuse)");
}

Figure narrow_mach_figure() {
  return row_figure(ArtefactScene::narrow_fold(),
                    "Across the edge of unequal triangles, lit at 45° (diffuse)");
}

Figure flicker_figure() {
  Figure figure;
  figure.title = "The brightest pixel of a sphere of 12 x 6 while it turns";
  figure.x_label = "turn about the axis, degrees";
  figure.y_label = "brightness, steps of 255";
  figure.curves.push_back(flicker_curve("reference (Phong, double)", ReferenceKind::kPhong));
  for (const ShadingRenderer& renderer : shading_renderers()) {
    const std::string shading(renderer.shading);
    figure.curves.push_back(flicker_curve(shading, shading));
  }
  return figure;
}

Figure rotation_figure() {
  Figure figure;
  figure.title = "One point while the picture turns (normals 60° apart)";
  figure.x_label = "turn in the image plane, degrees";
  figure.y_label = "brightness, steps of 255";
  figure.curves.push_back(rotation_curve("reference (Phong, double)", ReferenceKind::kPhong));
  figure.curves.push_back(rotation_curve("reference (slerp, double)", ReferenceKind::kSlerp));
  for (const ShadingRenderer& renderer : shading_renderers()) {
    const std::string shading(renderer.shading);
    figure.curves.push_back(rotation_curve(shading, shading));
  }
  return figure;
}

}  // namespace arcspan::tools
