// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/gpio/backend.hpp>
#include <arcspan/linux_host/gpio/line_name.hpp>

#include <charconv>
#include <filesystem>
#include <system_error>
#include <vector>

namespace arcspan::linux_host::gpio {
namespace {

constexpr std::string_view kDeviceFolder = "/dev/";
constexpr std::string_view kChip = "gpiochip";
constexpr unsigned kLargestOffset = 65535;

std::vector<std::string> chip_paths() {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(kDeviceFolder, error)) {
    // A symbolic link to a chip would make its lines ambiguous.
    if (entry.path().filename().string().starts_with(kChip) && !entry.is_symlink(error)) {
      paths.push_back(entry.path().string());
    }
  }
  return paths;
}

}  // namespace

std::optional<LineAddress> parse_line_address(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  std::string_view chip = text.substr(0, colon);
  if (chip.starts_with(kDeviceFolder)) chip.remove_prefix(kDeviceFolder.size());
  if (!chip.starts_with(kChip) || chip.find('/') != std::string_view::npos) return std::nullopt;
  const std::string_view digits = text.substr(colon + 1);
  LineAddress address{std::string(kDeviceFolder) + std::string(chip), 0};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), address.offset);
  if (error != std::errc() || end != digits.data() + digits.size() || address.offset > kLargestOffset) {
    return std::nullopt;
  }
  return address;
}

Result find_line_address(const std::string& text, LineAddress& address) {
  if (text.empty()) return Result::refused("a line needs a name", Status::kInvalidArgument);
  if (const std::optional<LineAddress> parsed = parse_line_address(text)) {
    address = *parsed;
    return {};
  }
  Result failure = Result::refused("no GPIO chip has a line of this name", Status::kIndexOutOfRange);
  bool found = false;
  for (const std::string& path : chip_paths()) {
    unsigned offset = 0;
    const Result result = find_line(path.c_str(), text.c_str(), offset);
    if (linux_host::ok(result)) {
      if (found) {
        return Result::refused("several GPIO chips have a line of this name; give CHIP:OFFSET",
                               Status::kInvalidArgument);
      }
      address = {path, offset};
      found = true;
    } else if (result.status != Status::kIndexOutOfRange) {
      failure = result;  // more informative than "not found"
    }
  }
  return found ? Result{} : failure;
}

}  // namespace arcspan::linux_host::gpio
