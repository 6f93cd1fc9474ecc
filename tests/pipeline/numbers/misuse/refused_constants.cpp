// SPDX-License-Identifier: MIT
// Constants that make() would refuse do not compile, and the compiler's message contains the word that ends
// the constant's line. check_words.py compares.
#include <arcspan/scene/camera.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/texture/texture.hpp>

using namespace arcspan;

using Light = Illumination<1, Highlight::kBlinn>;
using TwoLights = Illumination<2, Highlight::kBlinn, IlluminationFeatures{.coloured_lights = false}>;
using Prepared = PreparedMaterial<Gouraud<Light>>;
using PreparedTwo = PreparedMaterial<Gouraud<TwoLights>>;

constexpr Coefficient kHalf = Coefficient::of(0.5);
constexpr Coefficient kTwo = Coefficient::of(2.0);
constexpr ChannelCoefficients kGrey{kHalf, kHalf, kHalf};
constexpr ChannelCoefficients kRed{kHalf, {}, {}};
constexpr ChannelCoefficients kBright{kTwo, kTwo, kTwo};
constexpr Direction kAhead = normalised(0, 0, 1);
constexpr std::array kLamp{DirectionalLight{kAhead}};

constexpr Light kA = Light::of({kBright, kGrey, kGrey}, kLamp, kAhead);   // coefficient_outside_0_to_1
constexpr Light kB = Light::of({kGrey, kGrey, kGrey, 0}, kLamp, kAhead);  // shininess_outside_1_to_256
constexpr Light kC =
    Light::of({kGrey, kGrey, kGrey, 9, kTwo}, kLamp, kAhead);  // highlight_fade_outside_0_to_1
constexpr Light kD =
    Light::of({kGrey, kGrey, kGrey, 9, kHalf}, kLamp, kAhead);  // features_lack_fading_highlights
constexpr std::array kStrong{DirectionalLight{kAhead, kTwo}};
constexpr Light kE = Light::of({}, kStrong, kAhead);  // light_strength_outside_0_to_1
constexpr std::array kGlaring{DirectionalLight{kAhead, kHalf, kBright}};
constexpr Light kF = Light::of({}, kGlaring, kAhead);  // light_colour_outside_0_to_1
constexpr std::array kRedLamps{DirectionalLight{kAhead, kHalf, kRed}, DirectionalLight{kAhead}};
constexpr TwoLights kG = TwoLights::of({}, kRedLamps, kAhead);  // features_lack_coloured_lights

constexpr SceneLight kSun = SceneLight::directional(kAhead);
constexpr SceneLight kSuns[] = {kSun, kSun};
constexpr SceneLight kBulb[] = {SceneLight::point({}, {})};
constexpr SceneLight kRedSuns[] = {SceneLight::directional(kAhead, kHalf, kRed), kSun};
constexpr auto kH = Prepared::of({}, {kSuns});                  // more_lights_than_the_method_has
constexpr auto kI = Prepared::of({}, {{}, kBright});            // ambient_light_outside_0_to_1
constexpr auto kJ = Prepared::of({}, {kBulb});                  // half_distance_of_light_not_above_0
constexpr auto kK = Prepared::of({kGrey, kBright, kGrey}, {});  // coefficient_outside_0_to_1
constexpr auto kL = PreparedTwo::of({}, {kRedSuns});            // features_lack_coloured_lights

constexpr Placement kPlace{Rotation::identity(), {}};
constexpr ObjectLength kNear = ObjectLength::of(100);
constexpr ObjectLength kFar = ObjectLength::of(200);
constexpr PixelLength kFocal = PixelLength::of(100);
constexpr Placement kAway{Rotation::identity(), {ObjectLength::of(5000000), {}, {}}};
constexpr auto kM =
    ClipTransform::of(kPlace, {kFocal, kFar, kNear}, {64, 64});  // near_plane_not_between_0_and_far_plane
constexpr auto kN =
    ClipTransform::of(kPlace, {kFocal, kNear, kFar}, {64, 4096});            // picture_side_outside_1_to_2048
constexpr auto kO = ClipTransform::of(kPlace, {{}, kNear, kFar}, {64, 64});  // focal_length_not_above_0
constexpr auto kP =
    ClipTransform::of(kAway, {kFocal, kNear, kFar}, {64, 64});  // translation_beyond_2_to_the_22

constexpr WorldLength kOne = WorldLength::of(1);
constexpr WorldLength kTen = WorldLength::of(10);
constexpr Lens kLens = Lens::field_of_view(Turn{8192}, kOne, kTen);
constexpr LookAt kView{WorldPoint::of(0, 0, 5), {}};
constexpr LookAt kBlind{WorldPoint::of(0, 5, 0), {}};
constexpr Lens kWide = Lens::field_of_view(Turn{40000}, kOne, kTen);
constexpr Lens kFlat = Lens::orthographic({}, kOne, kTen);
constexpr Lens kInsideOut = Lens::focal_length(kFocal, kTen, kOne);
constexpr auto kQ = Camera::of(kView, kLens, {0, 64});        // picture_side_outside_1_to_2048
constexpr auto kR = Camera::of(kBlind, kLens, {64, 64});      // no_view_direction
constexpr auto kS = Camera::of(kView, kWide, {64, 64});       // field_of_view_out_of_range
constexpr auto kT = Camera::of(kView, kFlat, {64, 64});       // orthographic_height_out_of_range
constexpr auto kU = Camera::of(kView, kInsideOut, {64, 64});  // near_plane_not_between_0_and_far_plane

constexpr ObjectPosition kPositions[3] = {};
constexpr PackedNormal kNormals[3] = {};
constexpr std::uint8_t kIndices[] = {0, 1, 2, 3};
constexpr std::span kThree(kIndices, 3);
constexpr MeshView kMesh = MeshView::of(kPositions, kNormals, kThree);
constexpr MeshView kV =
    MeshView::of(kPositions, std::span(kNormals, 2), kThree);  // positions_and_normals_differ_in_number
constexpr MeshView kW = MeshView::of(kPositions, kNormals, kIndices);  // indices_not_a_multiple_of_3
constexpr MeshView kX = MeshView::of(kPositions, kNormals, std::span(kIndices + 1, 3));  // index_out_of_range
constexpr FacePlane kPlanes[2] = {};
constexpr std::span kPlane(kPlanes, 1);
constexpr MeshView kY = kMesh.with(kPlanes, PlaneScale{});          // planes_not_as_many_as_triangles
constexpr MeshView kZ = kMesh.with(kPlane, PlaneScale{100, 0, 0});  // plane_scale_out_of_range
constexpr TexturePoint kPoints[3] = {};
constexpr MeshView kAa =
    kMesh.with(std::span(kPoints, 2), TextureScale{});            // texture_points_not_as_many_as_vertices
constexpr MeshView kAb = kMesh.with(kPoints, TextureScale{100});  // texture_scale_out_of_range
constexpr Rgb8 kColours[2] = {};
constexpr MeshView kAc = kMesh.with(kColours);  // colours_not_as_many_as_vertices

using Picture = Texture<Palette8Texels<OpaqueColour>>;
constexpr std::uint8_t kTexels[64] = {};
constexpr std::uint16_t kPalette[256] = {};
constexpr auto kAd = Picture::of(kTexels, {2, 3, 1}, kPalette);  // texture_size_not_valid
constexpr auto kAe = Picture::of(kTexels, {4, 4, 1}, kPalette);  // words_fewer_than_the_texture_has
constexpr auto kAf =
    Picture::of(kTexels, {3, 3, 1}, std::span(kPalette, 16));  // palette_smaller_than_the_format_has
constexpr auto kAg = Texture<GrayTexels>::of(kTexels, {3, 3, 1}, kPalette);  // palette_for_a_format_without

constexpr Cosine kTooLarge = Cosine::of(2.0);  // constant_out_of_range
