// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/animation.hpp>
#include <arcspan_tools/output/palette.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <gif_lib.h>

#include <memory>

namespace arcspan::tools {
namespace {

void require(int result) {
  if (result == GIF_ERROR) throw Failure("GIF", "the library cannot write this animation");
}

int append(GifFileType* gif, const GifByteType* bytes, int count) {
  static_cast<std::string*>(gif->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  return count;
}

/// Tables of a GIF have a power of two of entries.
std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> colour_map(const std::vector<Rgb8>& colours) {
  int size = 2;
  while (size < static_cast<int>(colours.size())) size *= 2;
  std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(GifMakeMapObject(size, nullptr),
                                                                   &GifFreeMapObject);
  if (map == nullptr) throw std::bad_alloc();
  for (std::size_t i = 0; i < colours.size(); ++i)
    map->Colors[i] = {colours[i].r, colours[i].g, colours[i].b};
  return map;
}

/// The application extension that every reader of animations knows: repeat for ever.
void put_loop(GifFileType* gif) {
  const GifByteType for_ever[3] = {1, 0, 0};
  require(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
  require(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
  require(EGifPutExtensionBlock(gif, 3, for_ever));
  require(EGifPutExtensionTrailer(gif));
}

void put_frame(GifFileType* gif, const Image& frame, Palette& palette, int hundredths) {
  const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
  GifByteType extension[4];
  require(EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE,
                           static_cast<int>(EGifGCBToExtension(&control, extension)), extension));
  require(EGifPutImageDesc(gif, 0, 0, frame.width, frame.height, false, nullptr));
  std::vector<GifPixelType> row(static_cast<std::size_t>(frame.width));
  for (std::int32_t y = 0; y < frame.height; ++y) {
    for (std::int32_t x = 0; x < frame.width; ++x)
      row[static_cast<std::size_t>(x)] = palette.index(frame.at(x, y));
    require(EGifPutLine(gif, row.data(), frame.width));
  }
}

}  // namespace

std::string encode_gif(std::span<const Image> frames, std::int32_t milliseconds) {
  Palette palette(frames);
  const auto map = colour_map(palette.colours());
  std::string out;
  int error = 0;
  const auto close = [](GifFileType* gif) {
    int ignored = 0;
    EGifCloseFile(gif, &ignored);
  };
  std::unique_ptr<GifFileType, decltype(close)> gif(EGifOpen(&out, &append, &error), close);
  if (gif == nullptr) throw std::bad_alloc();
  EGifSetGifVersion(gif.get(), true);
  require(EGifPutScreenDesc(gif.get(), frames[0].width, frames[0].height, 8, 0, map.get()));
  put_loop(gif.get());
  std::int64_t shown = 0;
  std::int64_t hundredths = 0;
  for (const Image& frame : frames) {
    shown += milliseconds;
    const std::int64_t delay = (shown + 5) / 10 - hundredths;
    hundredths += delay;
    put_frame(gif.get(), frame, palette, static_cast<int>(delay));
  }
  require(EGifCloseFile(gif.release(), &error));
  return out;
}

}  // namespace arcspan::tools
