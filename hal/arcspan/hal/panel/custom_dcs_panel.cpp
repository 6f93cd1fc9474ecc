// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/custom_dcs_panel.hpp>

#include <cstddef>

namespace arcspan::hal {
namespace {

/// A command of a table, and where the next one begins.
struct TableEntry {
  std::uint8_t opcode = 0;
  std::span<const std::uint8_t> parameters{};
  std::size_t end = 0;  ///< 0 if the table ends within the command
};

[[nodiscard]] TableEntry entry_at(std::span<const std::uint8_t> table, std::size_t at) {
  const std::size_t left = table.size() - at;
  if (left < 2) return {};
  const std::size_t count = table[at + 1];
  if (count > left - 2) return {};
  return {table[at], table.subspan(at + 2, count), at + 2 + count};
}

}  // namespace

bool DcsController::is_valid() const {
  for (std::size_t at = 0; at < commands.size();) {
    const TableEntry entry = entry_at(commands, at);
    if (entry.end == 0 || entry.opcode == dcs::kSoftwareReset.opcode ||
        entry.opcode == dcs::kSleepIn.opcode || entry.opcode == dcs::kSleepOut.opcode)
      return false;
    at = entry.end;
  }
  return true;
}

Status CustomDcsPanel::send_commands() {
  for (std::size_t at = 0; at < controller_.commands.size();) {
    const TableEntry entry = entry_at(controller_.commands, at);
    const Status status = send(entry.opcode, entry.parameters);
    if (!ok(status)) return status;
    at = entry.end;
  }
  return Status::kOk;
}

}  // namespace arcspan::hal
