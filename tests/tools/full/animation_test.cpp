// SPDX-License-Identifier: MIT
// Every animation is read back after it is written: GIF by its library, APNG frame by frame as the PNGs that
// it is made of.
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/animation.hpp>
#include <arcspan_tools/output/frame_output.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <gif_lib.h>
#include <tests/tools/temporary_folder.hpp>

#include <cstdlib>
#include <cstring>
#include <numeric>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using arcspan::test::contents;
using arcspan::test::message_of;
using arcspan::test::TemporaryFolder;

namespace {

/// Frames with `colours` colours in all.
std::vector<Image> frames_with(std::int32_t colours, std::int32_t width = 40, std::int32_t height = 30) {
  std::vector<Image> frames(3, Image(width, height));
  std::int32_t next = 0;
  for (Image& frame : frames) {
    for (Rgb8& pixel : frame.pixels) {
      const std::int32_t c = next++ % colours;
      const std::int32_t shade = c * 255 / colours;
      pixel = {static_cast<std::uint8_t>(shade), static_cast<std::uint8_t>(255 - shade / 2),
               static_cast<std::uint8_t>(c % 7)};
    }
  }
  return frames;
}

struct Decoded {
  std::vector<Image> frames;
  std::vector<std::int32_t> delays;
};

Decoded decode_gif(std::string bytes) {
  struct Reader {
    std::string bytes;
    std::size_t at = 0;
  } reader{std::move(bytes)};
  const auto read = [](GifFileType* gif, GifByteType* to, int count) {
    auto& from = *static_cast<Reader*>(gif->UserData);
    const std::size_t taken =
        from.bytes.copy(reinterpret_cast<char*>(to), static_cast<std::size_t>(count), from.at);
    from.at += taken;
    return static_cast<int>(taken);
  };
  int error = 0;
  GifFileType* gif = DGifOpen(&reader, read, &error);
  REQUIRE(gif != nullptr);
  REQUIRE(DGifSlurp(gif) == GIF_OK);
  Decoded decoded;
  for (int i = 0; i < gif->ImageCount; ++i) {
    const SavedImage& saved = gif->SavedImages[i];
    Image frame(saved.ImageDesc.Width, saved.ImageDesc.Height);
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
      const GifColorType& c = gif->SColorMap->Colors[saved.RasterBits[k]];
      frame.pixels[k] = {c.Red, c.Green, c.Blue};
    }
    decoded.frames.push_back(frame);
    GraphicsControlBlock control;
    REQUIRE(DGifSavedExtensionToGCB(gif, i, &control) == GIF_OK);
    decoded.delays.push_back(control.DelayTime);
  }
  CHECK(DGifCloseFile(gif, &error) == GIF_OK);
  return decoded;
}

struct Chunk {
  std::string type;
  std::string data;
};

std::uint32_t u32(std::string_view bytes, std::size_t at) {
  std::uint32_t v = 0;
  for (std::size_t i = 0; i < 4; ++i) v = (v << 8) | static_cast<unsigned char>(bytes[at + i]);
  return v;
}

std::string text(std::uint32_t v) {
  std::string out;
  for (int i = 3; i >= 0; --i) out.push_back(static_cast<char>(v >> (8 * i)));
  return out;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const std::vector<std::uint8_t> bytes(body.begin(), body.end());
  return text(static_cast<std::uint32_t>(data.size())) + body + text(crc32(bytes));
}

std::vector<Chunk> chunks_of(const std::string& png) {
  REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t size = u32(png, at);
    REQUIRE(at + 12 + size <= png.size());
    chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, size)});
    CHECK(chunk(chunks.back().type, chunks.back().data) == png.substr(at, 12 + size));
    at += 12 + size;
  }
  return chunks;
}

}  // namespace

TEST_CASE("a GIF of up to 256 colours is exact") {
  const std::int32_t colours = GENERATE(1, 2, 3, 200, 256);
  const std::vector<Image> frames = frames_with(colours);
  const Decoded decoded = decode_gif(encode_gif(frames, 50));
  REQUIRE(decoded.frames.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(decoded.frames[i] == frames[i]);
}

TEST_CASE("a GIF of more colours takes near ones") {
  const std::vector<Image> frames = frames_with(1200);
  const Decoded decoded = decode_gif(encode_gif(frames, 50));
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < frames[i].pixels.size(); ++k) {
      const Rgb8 a = frames[i].pixels[k];
      const Rgb8 b = decoded.frames[i].pixels[k];
      squares += double((a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b));
    }
  }
  CHECK(squares / (3.0 * 3.0 * 1200) < 16);  // of 255 squared, a channel
}

TEST_CASE("a GIF lasts as long as it should") {
  const Decoded decoded = decode_gif(encode_gif(std::vector<Image>(12, Image(2, 2)), 33));
  CHECK(std::accumulate(decoded.delays.begin(), decoded.delays.end(), 0) == 40);
  const auto [least, most] = std::minmax_element(decoded.delays.begin(), decoded.delays.end());
  CHECK(*least == 3);
  CHECK(*most == 4);
}

TEST_CASE("an animated PNG holds every frame exactly") {
  const std::vector<Image> frames = frames_with(1200);
  const std::vector<Chunk> chunks = chunks_of(encode_apng(frames, 70));
  REQUIRE(chunks.front().type == "IHDR");
  REQUIRE(chunks.back().type == "IEND");
  REQUIRE(chunks[1].type == "acTL");
  CHECK(u32(chunks[1].data, 0) == 3);
  CHECK(u32(chunks[1].data, 4) == 0);
  const TemporaryFolder folder;
  std::uint32_t sequence = 0;
  std::size_t frame = 0;
  for (std::size_t i = 2; i + 1 < chunks.size(); i += 2, ++frame) {
    REQUIRE(chunks[i].type == "fcTL");
    REQUIRE(chunks[i].data.size() == 26);
    CHECK(u32(chunks[i].data, 0) == sequence++);
    CHECK(u32(chunks[i].data, 4) == 40);
    CHECK(u32(chunks[i].data, 8) == 30);
    CHECK(chunks[i].data.substr(20, 4) == std::string("\x00\x46\x03\xE8", 4));  // 70 of 1000
    std::string data = chunks[i + 1].data;
    if (frame == 0) {
      CHECK(chunks[i + 1].type == "IDAT");
    } else {
      REQUIRE(chunks[i + 1].type == "fdAT");
      CHECK(u32(data, 0) == sequence++);
      data = data.substr(4);
    }
    const std::string png = std::string("\x89PNG\r\n\x1a\n") + chunk("IHDR", chunks[0].data) +
                            chunk("IDAT", data) + chunk("IEND", "");
    CHECK(read_image(folder.file("frame.png", png)) == frames[frame]);
  }
  CHECK(frame == 3);
}

TEST_CASE("frames in a folder appear all at once, or not at all") {
  const TemporaryFolder folder;
  const std::string target = folder / "frames";
  FrameFormat format;
  format.frames = 2;
  format.size = {40, 30};
  const std::vector<Image> frames = frames_with(7);
  {
    const auto output = make_frame_output(target + "/", format);
    output->add(frames[0]);
    CHECK_FALSE(std::filesystem::exists(target));
  }
  CHECK(folder.size() == 0);
  for (int again = 0; again < 2; ++again) {
    const auto output = make_frame_output(target, format);
    output->add(frames[0]);
    output->add(frames[1]);
    output->finish("");
  }
  CHECK(folder.size() == 1);
  CHECK(read_image(target + "/frame-0001.png") == frames[1]);
  format.frames = 1;
  CHECK(message_of<Failure>([&] { (void)make_frame_output(target, format); }) ==
        target + ": holds frame-0001.png of a longer animation; remove it first");
  const std::string file = folder.file("file", "mine");
  CHECK(message_of<Failure>([&] { (void)make_frame_output(file + "/", format); }) ==
        file + "/: cannot write (it is no directory)");
}

TEST_CASE("an animation that no memory would hold is refused before it is drawn") {
  FrameFormat format;
  format.frames = 100;
  format.size = {2048, 2048};
  CHECK(message_of<Failure>([&] { (void)make_frame_output("a.gif", format); }) ==
        "a.gif: too large an animation (100 frames of 2048x2048; the limit is 268435456 pixels in all; a "
        "folder has "
        "none)");
  CHECK(message_of<Failure>([&] { (void)make_frame_output("a.mp4", format); }) ==
        "a.mp4: an animation's name must end in .gif or .png, a folder's in a slash");
}
