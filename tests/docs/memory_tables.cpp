// SPDX-License-Identifier: MIT
// The sizes in the tables of docs/memory.md.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;
using Lights4 = Illumination<4, Highlight::kBlinn>;
static_assert(hal::Framebuffer<Rgb888>::words(320, 1) * sizeof(Rgb888::Word) == 960);
static_assert(hal::Framebuffer<Gray4>::words(320, 1) == 160 && hal::Framebuffer<Mono>::words(320, 1) == 40);
static_assert(sizeof(CachedVertex<Flat<Light>>) == 10 && sizeof(CachedVertex<Gouraud<Light>>) == 24);
static_assert(sizeof(CachedVertex<Arc<Light>>) == 28 && sizeof(CachedVertex<Arc<Lights4>>) == 52);
using Lights2 = Illumination<2, Highlight::kBlinn>;
static_assert(sizeof(Light) <= 2000 && sizeof(Lights2) <= 3050 && sizeof(Lights4) <= 5200);
constexpr bool k64Bits = sizeof(void*) == 8;
template <class L, TexelLight Colours>
constexpr std::size_t kOnTexture = sizeof(typename Textured<Arc<L>, DirectTexels<>, Colours>::Lighting) -
                                   sizeof(L);
constexpr std::size_t kTextureView = k64Bits ? 32 : 16;
static_assert(kOnTexture<Light, TexelLight::kGrey> <= 256 + 512 + kTextureView);
static_assert(kOnTexture<Light, TexelLight::kColoured> <= 512 + kTextureView);
static_assert(kOnTexture<Lights2, TexelLight::kGrey> <= 512 + kTextureView);
using Grey = Textured<Arc<Light>, DirectTexels<>>;
static_assert(sizeof(TexturePoint) == 4 &&
              sizeof(CachedVertex<Grey>) == sizeof(CachedVertex<Arc<Light>>) + 12);
static_assert(Texture<DirectTexels<>>::words({7, 7, 8}) == 21845);
static_assert(Texture<Palette4Texels<>>::words({7, 7, 1}) == 8192 && Palette8Texels<>::kPaletteSize == 256);
static_assert(sizeof(Fog) <= 280 && sizeof(Opacity<>) == 4 && sizeof(ScreenDoor) == 4);
static_assert(sizeof(Texture<DirectTexels<>>) <= kTextureView);
static_assert(sizeof(Illumination<1, Highlight::kPhong>) <= sizeof(Light) + 4);
static_assert(sizeof(VertexCache<Arc<Light>>) <= 256);
static_assert(sizeof(ObjectPosition) + sizeof(PackedNormal) == 10);
using TwoLights = Arc<Illumination<2, Highlight::kBlinn>>;
using OneObject = SceneMemory<MethodList<TwoLights>, 1>;
using TwoObjects = SceneMemory<MethodList<TwoLights>, 2>;
static_assert(sizeof(TwoObjects) - sizeof(OneObject) <= 200);
static_assert(sizeof(Object) <= (k64Bits ? 96 : 80));
static_assert(sizeof(SceneMemory<MethodList<TwoLights>, 2, 312, 588>) <= (k64Bits ? 15984 : 15848));
