// SPDX-License-Identifier: MIT
// The bodies of stb, which are held neither to this project's warnings nor to its static analysis. The macros
// leave out what is not used and must agree with nobody: image_file.cpp sees declarations only.
#include <arcspan_tools/image/stb_memory.hpp>

#include <cstdlib>

namespace {

thread_local std::size_t most_bytes = 0;

void* resized(void* block, std::size_t bytes) {
  return bytes > most_bytes ? nullptr : std::realloc(block, bytes);
}

}  // namespace

void arcspan::tools::limit_stb_memory(std::size_t bytes) { most_bytes = bytes; }

#define STBI_MALLOC(bytes) resized(nullptr, bytes)
#define STBI_REALLOC(block, bytes) resized(block, bytes)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#include <stb/stb_image_resize.h>
