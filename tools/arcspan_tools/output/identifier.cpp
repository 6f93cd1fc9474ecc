// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/mesh_writer.hpp>

#include <algorithm>
#include <array>

namespace arcspan::tools {
namespace {

// The keywords of C++20 ([lex.key], table 5 and the alternative tokens), `std`, and the library's own
// namespace.
constexpr std::array<std::string_view, 95> kTaken{
    "alignas",   "alignof",       "and",         "and_eq",       "arcspan",
    "asm",       "auto",          "bitand",      "bitor",        "bool",
    "break",     "case",          "catch",       "char",         "char16_t",
    "char32_t",  "char8_t",       "class",       "co_await",     "co_return",
    "co_yield",  "compl",         "concept",     "const",        "const_cast",
    "consteval", "constexpr",     "constinit",   "continue",     "decltype",
    "default",   "delete",        "do",          "double",       "dynamic_cast",
    "else",      "enum",          "explicit",    "export",       "extern",
    "false",     "float",         "for",         "friend",       "goto",
    "if",        "inline",        "int",         "long",         "main",
    "mutable",   "namespace",     "new",         "noexcept",     "not",
    "not_eq",    "nullptr",       "operator",    "or",           "or_eq",
    "private",   "protected",     "public",      "register",     "reinterpret_cast",
    "requires",  "return",        "short",       "signed",       "sizeof",
    "static",    "static_assert", "static_cast", "std",          "struct",
    "switch",    "template",      "this",        "thread_local", "throw",
    "true",      "try",           "typedef",     "typeid",       "typename",
    "union",     "unsigned",      "using",       "virtual",      "void",
    "volatile",  "wchar_t",       "while",       "xor",          "xor_eq"};

// Names that compilers and the headers that a compiled model includes define as macros, and keywords of C
// that C++ does not have.
constexpr std::array<std::string_view, 7> kMacros{"EOF",      "NULL",   "i386", "linux",
                                                  "restrict", "typeof", "unix"};

/// Limits and makers of the standard integers, such as INT8_MAX and UINT64_C.
bool is_integer_macro(std::string_view text) {
  const bool begins = text.starts_with("INT") || text.starts_with("UINT") || text.starts_with("SIZE_") ||
                      text.starts_with("PTRDIFF_") || text.starts_with("WCHAR_") ||
                      text.starts_with("WINT_") || text.starts_with("SIG_ATOMIC_");
  return begins && (text.ends_with("_MAX") || text.ends_with("_MIN") || text.ends_with("_C"));
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_decimal(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_identifier(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return false;
  for (const char c : text) {
    if (!is_letter(c) && !is_decimal(c) && c != '_') return false;
  }
  // Two underscores in a row are the compiler's.
  return text.find("__") == std::string_view::npos &&
         std::find(kTaken.begin(), kTaken.end(), text) == kTaken.end() &&
         std::find(kMacros.begin(), kMacros.end(), text) == kMacros.end() && !is_integer_macro(text);
}

std::string identifier(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (is_letter(c) || is_decimal(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return "mesh";
  return is_identifier(name) ? name : "mesh_" + name;
}

}  // namespace arcspan::tools
