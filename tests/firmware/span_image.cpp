// SPDX-License-Identifier: MIT
// The span stage of every method that promises not to divide, as functions of a linked image: image_test.py
// looks at what they reach. In other programs the compiler has merged them with the stages around. They are
// the object of tests/objects/span_stage.cpp.
int main() { return 0; }
