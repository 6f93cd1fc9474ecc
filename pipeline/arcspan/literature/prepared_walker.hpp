// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/row_in_pieces.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstdint>

namespace arcspan {

/// Row walker of a method whose prepared part goes down the rows itself, by next_row() and enter_lower().
/// `MethodRun::of_row(prepared, start)` makes the run of a row.
template <class Prepared, class MethodRun>
class PreparedWalker {
 public:
  using Run = MethodRun;
  constexpr explicit PreparedWalker(Prepared& prepared) : prepared_(&prepared) {}
  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run::of_row(*prepared_, start); }
  constexpr void next_row() { prepared_->next_row(); }
  constexpr void enter_lower() { prepared_->enter_lower(); }

 private:
  Prepared* prepared_;
};

/// PreparedWalker of rows that are drawn in pieces of MethodRun::length() pixels.
template <class Prepared, class MethodRun>
class PreparedWalkerInPieces : public PreparedWalker<Prepared, MethodRun> {
 public:
  using Piece = MethodRun;
  using Run = literature::RowInPieces<PreparedWalkerInPieces>;
  using PreparedWalker<Prepared, MethodRun>::PreparedWalker;
  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(*this, start); }
  [[nodiscard]] constexpr Piece piece(const RowStart& start) const {
    return PreparedWalker<Prepared, MethodRun>::row(start);
  }
};

}  // namespace arcspan
