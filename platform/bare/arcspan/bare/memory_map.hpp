// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// Symbols that sections.ld defines. Only their addresses have a meaning.
extern "C" {
extern std::uint32_t arcspan_stack_bottom[];
extern std::uint32_t arcspan_stack_top[];
extern std::uint32_t arcspan_stack_floor[];
extern std::uint32_t arcspan_data_begin[];
extern std::uint32_t arcspan_data_end[];
extern const std::uint32_t arcspan_data_image[];
extern std::uint32_t arcspan_bss_begin[];
extern std::uint32_t arcspan_bss_end[];
}
