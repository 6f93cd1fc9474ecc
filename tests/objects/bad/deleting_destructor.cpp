// SPDX-License-Identifier: MIT
// must be rejected by: allocation
// A virtual destructor pulls in operator delete even where nothing is ever allocated.
struct Bus {
  virtual ~Bus();
};
Bus::~Bus() = default;
