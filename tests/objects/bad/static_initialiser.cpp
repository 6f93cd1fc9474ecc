// SPDX-License-Identifier: MIT
// must be rejected by: static initialisation
int first_width();
int width = first_width();
