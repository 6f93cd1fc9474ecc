// SPDX-License-Identifier: MIT
// must be rejected by: exceptions
int checked(int value) {
  if (value < 0) throw value;
  return value;
}
