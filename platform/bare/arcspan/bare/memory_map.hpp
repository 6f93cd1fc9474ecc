// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// Addresses that sections.ld defines; only the addresses of these objects mean something.
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
