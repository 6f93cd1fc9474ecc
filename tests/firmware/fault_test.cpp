// SPDX-License-Identifier: MIT
// An instruction that does not exist must be reported and end the program with kExitFault.
int main() {
  __builtin_trap();
  return 0;
}
