// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/wire_script.hpp>

#include <charconv>
#include <optional>
#include <span>

namespace arcspan::hal::sim {
namespace {

using Kind = WireEvent::Kind;
using WordList = std::vector<std::string_view>;

constexpr std::size_t kMostBytes = 1u << 24;

WordList words_of(std::string_view line) {
  WordList words;
  constexpr std::string_view kBlank = " \t\r";
  std::size_t at = line.find_first_not_of(kBlank);
  while (at != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlank, at);
    words.push_back(line.substr(at, end == std::string_view::npos ? end : end - at));
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

std::optional<std::uint64_t> number(std::string_view text, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Level> level_of(std::string_view word) {
  if (word == "low") return Level::kLow;
  if (word == "high") return Level::kHigh;
  return std::nullopt;
}

std::optional<Status> status_of(std::string_view text) {
  for (int i = 0; i <= static_cast<int>(Status::kCacheMismatch); ++i) {
    const auto status = static_cast<Status>(i);
    if (text == arcspan::to_string(status)) return status;
  }
  return std::nullopt;
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Appends the bytes of `words` to `bytes`; a last word "xN" repeats the others N times. Returns the error,
/// or "".
std::string read_bytes(std::span<const std::string_view> words, std::vector<std::uint8_t>& bytes) {
  std::uint64_t times = 1;
  if (!words.empty() && words.back().starts_with('x')) {
    const std::optional<std::uint64_t> count = number(words.back().substr(1), 10);
    if (!count || *count == 0 || *count > kMostBytes) return "not a number of times: " + quoted(words.back());
    times = *count;
    words = words.first(words.size() - 1);
  }
  if (words.empty()) return "no bytes";
  if (times * words.size() > kMostBytes) return "too many bytes";
  std::vector<std::uint8_t> once;
  for (const std::string_view word : words) {
    const std::optional<std::uint64_t> value = number(word, 16);
    if (!value || *value > 255) return "not a byte: " + quoted(word);
    once.push_back(static_cast<std::uint8_t>(*value));
  }
  for (std::uint64_t i = 0; i < times; ++i) bytes.insert(bytes.end(), once.begin(), once.end());
  return "";
}

std::string read_delay(const WordList& words, WireEvent& event) {
  const std::optional<std::uint64_t> count = words.size() == 3 ? number(words[1], 10) : std::nullopt;
  const bool ms = words.size() == 3 && words[2] == "ms";
  if (!count || *count == 0 || *count > UINT32_MAX || (!ms && words[2] != "us"))
    return "expected: wait NUMBER us|ms";
  if (!ok(event.answer)) return "a delay cannot fail";
  event.kind = Kind::kDelay;
  event.us = ms ? *count * 1000 : *count;
  return "";
}

std::string read_pin(const WordList& words, WireEvent& event) {
  const bool reads = words[0] == "read";
  const std::optional<Level> level =
      words.size() == (reads ? 3u : 2u) ? level_of(words.back()) : std::nullopt;
  if (!level) return "expected: command, data, i2c, wait, read PIN low|high or PIN low|high";
  event.kind = reads ? Kind::kRead : Kind::kSet;
  event.pin = words[reads ? 1 : 0];
  event.level = *level;
  return "";
}

std::string read_event(const WordList& words, WireEvent& event) {
  const std::span<const std::string_view> rest = std::span(words).subspan(1);
  if (words[0] == "wait") return read_delay(words, event);
  if (words[0] == "command" || words[0] == "data") {
    event.kind = Kind::kSpi;
    event.level = words[0] == "data" ? Level::kHigh : Level::kLow;
    return read_bytes(rest, event.bytes);
  }
  if (words[0] == "i2c") {
    event.kind = Kind::kI2c;
    const std::optional<std::uint64_t> address = rest.empty() ? std::nullopt : number(rest[0], 16);
    if (!address || *address > 127) return "no address of 7 bits";
    event.address = static_cast<std::uint8_t>(*address);
    return read_bytes(rest.subspan(1), event.bytes);
  }
  return read_pin(words, event);
}

std::string read_line(std::string_view line, WireEvent& event) {
  if (const std::size_t equals = line.find('='); equals != std::string_view::npos) {
    std::string name;
    for (const std::string_view word : words_of(line.substr(equals + 1))) {
      name += (name.empty() ? "" : " ") + std::string(word);
    }
    const std::optional<Status> status = status_of(name);
    if (!status) return "not a status: " + quoted(name);
    event.answer = *status;
    line = line.substr(0, equals);
  }
  const WordList words = words_of(line);
  return words.empty() ? "nothing before =" : read_event(words, event);
}

const char* word_of(Level level) { return level == Level::kHigh ? "high" : "low"; }

std::string hex_byte(unsigned byte) {
  const char* digits = "0123456789abcdef";
  return {' ', digits[byte >> 4 & 15], digits[byte & 15]};
}

/// Number of times the `period` bytes at `at` occur in a row.
std::size_t repeats(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t period) {
  std::size_t end = at + period;
  while (end < bytes.size() && bytes[end] == bytes[end - period]) ++end;
  return end <= bytes.size() ? (end - at) / period : 0;
}

/// Part of `bytes` from `at` on that fits on a line; moves `at` behind it. Repeated bytes and repeated pairs
/// of bytes (pixels of one colour) are written as "xN".
std::string line_of_bytes(const std::vector<std::uint8_t>& bytes, std::size_t& at) {
  constexpr std::size_t kBytesOfLine = 32;
  constexpr std::size_t kWorthCounting = 8;
  std::string text;
  for (std::size_t count = 0; at < bytes.size() && count < kBytesOfLine; ++count, ++at) {
    for (const std::size_t period : {std::size_t{1}, std::size_t{2}}) {
      const std::size_t times = repeats(bytes, at, period);
      if (times * period < kWorthCounting) continue;
      if (count > 0) return text;
      for (std::size_t i = 0; i < period; ++i) text += hex_byte(bytes[at + i]);
      at += times * period;
      return text + " x" + std::to_string(times);
    }
    text += hex_byte(bytes[at]);
  }
  return text;
}

std::string head_of(const WireEvent& event) {
  switch (event.kind) {
    case Kind::kSpi:
      return event.level == Level::kHigh ? "data" : "command";
    case Kind::kI2c:
      return "i2c" + hex_byte(event.address);
    case Kind::kSet:
      return event.pin + " " + word_of(event.level);
    case Kind::kRead:
      return "read " + event.pin + " " + word_of(event.level);
    case Kind::kDelay:
      break;
  }
  const bool ms = event.us % 1000 == 0;
  return "wait " + std::to_string(ms ? event.us / 1000 : event.us) + (ms ? " ms" : " us");
}

std::string answer_of(const WireEvent& event) {
  return ok(event.answer) ? "" : std::string(" = ") + arcspan::to_string(event.answer);
}

}  // namespace

WireScript parse_wire_script(std::string_view text) {
  WireScript script;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    std::string_view content = text.substr(0, end);
    text = end == std::string_view::npos ? "" : text.substr(end + 1);
    content = content.substr(0, content.find('#'));
    if (words_of(content).empty()) continue;
    WireEvent event;
    event.line = line;
    const std::string wrong = read_line(content, event);
    if (!wrong.empty()) {
      script.error = "line " + std::to_string(line) + ": " + wrong;
      return script;
    }
    script.events.push_back(std::move(event));
  }
  return script;
}

std::string to_string(const WireEvent& event) {
  std::string text = head_of(event);
  std::size_t at = 0;
  if (!event.bytes.empty()) text += line_of_bytes(event.bytes, at);
  if (at < event.bytes.size()) text += " ... (" + std::to_string(event.bytes.size()) + " bytes)";
  return text + answer_of(event);
}

std::string to_script(const std::vector<WireEvent>& events) {
  std::string text;
  for (const WireEvent& event : events) {
    std::size_t at = 0;
    do {
      text += head_of(event);
      if (event.kind == Kind::kI2c) {
        // A transaction is always one line.
        for (const std::uint8_t byte : event.bytes) text += hex_byte(byte);
        at = event.bytes.size();
      } else if (!event.bytes.empty()) {
        text += line_of_bytes(event.bytes, at);
      }
      if (at == event.bytes.size()) text += answer_of(event);
      text += '\n';
    } while (at < event.bytes.size());
  }
  return text;
}

}  // namespace arcspan::hal::sim
