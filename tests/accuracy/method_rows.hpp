// SPDX-License-Identifier: MIT
#pragma once

/// Prints the heading and the text above the table of print_method_rows().
void print_method_section();

/// Prints how far the integers of every other method are from the method's own model in double precision,
/// from so many triangles a figure.
void print_method_rows(int triangles);
