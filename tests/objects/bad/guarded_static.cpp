// SPDX-License-Identifier: MIT
// must be rejected by: state
int count() {
  static int calls = 0;
  return ++calls;
}
