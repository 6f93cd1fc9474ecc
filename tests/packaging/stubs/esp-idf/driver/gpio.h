// SPDX-License-Identifier: MIT
#include <signatures.h>
