// SPDX-License-Identifier: MIT
// The value of main() must become the exit status of the emulator.
int main() { return 7; }
