// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/read_mtl.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

/// Statements without an effect on a surface that neither reflects nor refracts: they need no warning.
constexpr std::string_view kSilent[] = {"Ni", "Tf", "sharpness", "Km"};

class MtlReader {
 public:
  MtlReader(TextLines& lines, const std::string& folder, MtlMaterials& materials)
      : lines_(lines), folder_(folder), materials_(materials) {}

  void read() {
    while (lines_.next()) {
      if (lines_.words().empty()) continue;
      try {
        statement(lines_.words()[0]);
      } catch (const Failure& failure) {
        if (materials_.wrong++ == 0) materials_.first_wrong = failure.what();
      }
    }
  }

 private:
  void statement(std::string_view keyword) {
    if (keyword == "newmtl") return begin();
    if (material_ == nullptr) lines_.fail(in_quotes(keyword) + " before any newmtl");
    if (keyword == "Kd") {
      material_->look.colour = colour();
    } else if (keyword == "Ka") {
      material_->look.ambient_colour = colour();
      if (is_grey(material_->look.ambient_colour)) material_->look.ambient_colour.reset();
    } else if (keyword == "Ks") {
      specular_ = colour();
      set_highlight();
    } else if (keyword == "Ke") {
      material_->look.emission = colour().value_or(Vec3{});
    } else if (keyword == "Ns") {
      constexpr double kLeast = 1;
      constexpr double kMost = 256;
      material_->look.shininess =
          static_cast<std::int32_t>(std::lround(std::clamp(lines_.number_at(1), kLeast, kMost)));
    } else if (keyword == "illum") {
      illum_ = lines_.integer_at(1, 0, 10, "illumination model");
      if (illum_ > 2) materials_.left_out.add("illum " + std::to_string(illum_));
      set_highlight();
    } else if (keyword == "map_Kd") {
      material_->look.sampler = {};
      material_->colour_map = file_name();
    } else if (keyword == "map_d") {
      material_->opacity_map = file_name();
    } else if (keyword == "d") {
      opacity(lines_.number_at(lines_.words().size() - 1));
    } else if (keyword == "Tr") {
      opacity(1 - lines_.number_at(1));
    } else if (std::find(std::begin(kSilent), std::end(kSilent), keyword) == std::end(kSilent)) {
      materials_.left_out.add(std::string(keyword));
    }
  }

  void begin() {
    const Readings name = lines_.name();
    material_ = nullptr;
    if (name[0].empty()) lines_.fail("a material has no name");
    material_ = &materials_.by_name.insert_or_assign(name[0], MtlEntry{}).first->second;
    material_->look.name = name[0];
    for (const std::string& reading : name) materials_.written_for.insert_or_assign(reading, name[0]);
    specular_.reset();
    illum_ = 2;
  }

  /// The name at the end of a map statement, which may have blanks. Options before it, and what they say, are
  /// left out.
  Readings file_name() {
    const std::vector<std::string_view>& words = lines_.words();
    std::size_t at = 1;
    while (at < words.size() && words[at].starts_with("-")) {
      if (words[0] == "map_Kd" && words[at] == "-clamp" && at + 1 < words.size()) {
        clamp(words[at + 1] == "on");
        at += 2;
        continue;
      }
      materials_.left_out.add(std::string(words[0]) + " " + std::string(words[at]));
      at += 1 + arguments_of(words[at]);
      // -o, -s and -t have one to three numbers.
      while (at + 1 < words.size() && at > 1 && parse_number(words[at])) ++at;
    }
    Readings name = lines_.name(at);
    if (name[0].empty()) lines_.fail(in_quotes(words[0]) + " names no file");
    // Some programs write where the picture is from the material file, others where it is from the model,
    // others where it is on their own machine.
    Readings names;
    for (const std::string& reading : name) names.push_back(folder_ + reading);
    if (!folder_.empty()) names.insert(names.end(), name.begin(), name.end());
    for (const std::string& reading : name) {
      if (const std::size_t slash = reading.find_last_of("/\\"); slash != std::string::npos)
        names.push_back(reading.substr(slash + 1));
    }
    return names;
  }

  void clamp(bool on) {
    const TextureWrap wrap = on ? TextureWrap::kClamp : TextureWrap::kRepeat;
    material_->look.sampler = {wrap, wrap};
  }

  /// The least number of words after an option of a map.
  static std::size_t arguments_of(std::string_view option) { return option == "-mm" ? 2 : 1; }

  // illum may stand before Ks or after it.
  void set_highlight() {
    material_->look.unlit = illum_ == 0;
    material_->look.specular = illum_ == 1 ? Vec3{} : specular_;
  }

  // A material that cannot be seen is one of the exporters that write d or Tr the other way round.
  void opacity(double value) {
    materials_.invisible = materials_.invisible || value <= 0;
    material_->look.opacity = value <= 0 ? 1 : std::min(value, 1.0);
  }

  static bool is_grey(const std::optional<Vec3>& c) { return c && c->x == c->y && c->y == c->z; }

  /// Three numbers, or one for all channels. Spectra and CIE colours give nothing.
  std::optional<Vec3> colour() {
    if (lines_.words().size() > 1 && (lines_.words()[1] == "spectral" || lines_.words()[1] == "xyz")) {
      materials_.left_out.add(std::string(lines_.words()[0]) + " " + std::string(lines_.words()[1]));
      return std::nullopt;
    }
    const double red = channel(1);
    if (lines_.words().size() == 2) return Vec3{red, red, red};
    return Vec3{red, channel(2), channel(3)};
  }

  double channel(std::size_t i) {
    const double value = lines_.number_at(i);
    if (value < 0) lines_.fail(in_quotes(lines_.words()[i]) + " is not a colour (0...1)");
    materials_.too_bright = materials_.too_bright || value > 1;
    return std::min(value, 1.0);
  }

  TextLines& lines_;
  const std::string& folder_;
  MtlMaterials& materials_;
  MtlEntry* material_ = nullptr;
  std::optional<Vec3> specular_;
  std::int64_t illum_ = 2;
};

}  // namespace

const MtlEntry* MtlMaterials::find(const Readings& name) const {
  for (const std::string& reading : name) {
    if (const auto found = by_name.find(reading); found != by_name.end()) return &found->second;
  }
  for (const std::string& reading : name) {
    if (const auto found = written_for.find(reading); found != written_for.end())
      return &by_name.at(found->second);
  }
  return nullptr;
}

void read_mtl(std::string_view bytes, const std::string& subject, const std::string& folder,
              MtlMaterials& materials) {
  const std::string text = plain_text(bytes);
  TextLines lines(text, subject, TextLines::Joining::kBackslash);
  MtlReader(lines, folder, materials).read();
}

void warn_of(const MtlMaterials& materials, std::vector<std::string>& warnings) {
  materials.left_out.warn(warnings);
  if (materials.wrong > 0) {
    warnings.push_back("left out: wrong statements of materials (" + std::to_string(materials.wrong) +
                       "), the first: " + materials.first_wrong);
  }
  if (materials.invisible) {
    warnings.emplace_back("fully transparent materials (d 0, Tr 1) are drawn opaque");
  }
  if (materials.too_bright) warnings.emplace_back("colours of materials above 1 are drawn as 1");
}

}  // namespace arcspan::tools
