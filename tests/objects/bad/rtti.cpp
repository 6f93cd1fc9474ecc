// SPDX-License-Identifier: MIT
// must be rejected by: rtti
struct Panel {
  virtual int width() const;
};
struct ColourPanel : Panel {};
const ColourPanel* as_colour(const Panel* panel) { return dynamic_cast<const ColourPanel*>(panel); }
