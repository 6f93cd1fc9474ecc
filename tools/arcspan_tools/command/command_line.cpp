// SPDX-License-Identifier: MIT
#include <arcspan/version.hpp>

#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/unexpected.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/temporaries.hpp>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongArguments = 2;

int complain(const std::string& what, int status) {
  print_message(what);
  return status;
}

// A closed standard stream is opened in the direction in which nobody can use it: otherwise the next file
// that is opened would take its number, and a report would be written into it.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

// A caller may have left signals ignored that this program needs.
void prepare_process() {
  occupy_standard_streams();
  (void)std::signal(SIGCHLD, SIG_DFL);  // waitpid() finds no child without this
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the user's limit fails with a message instead
  remove_temporaries_at_signals();
}

// Printing may fail, for example because a disk is full.
int flushed() {
  std::cout.flush();
  const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  return lost ? complain("standard output: cannot write", kFailed) : 0;
}

// Whether a subcommand exists, but not in this build (ARCSPAN_TOOLS_DRAWING_ONLY).
bool is_left_out(const std::string& subcommand) {
  if (subcommand.empty()) return false;
  return std::string_view(" " ARCSPAN_LEFT_OUT_COMMANDS " ").find(" " + subcommand + " ") !=
         std::string_view::npos;
}

std::string what_is_missing(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) return "no subcommand given (see arcspan --help)";
  if (extras[0].starts_with("-")) return unexpected_argument(app).value();
  if (is_left_out(extras[0])) {
    return "this build has no subcommand '" + extras[0] +
           "' (docs/getting-started.md says how to build the whole tool)";
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const std::optional<std::string> meant = closest_word(extras[0], names);
  return "no such subcommand: '" + extras[0] + "'" +
         (meant ? "; did you mean '" + *meant + "'?" : " (see arcspan --help)");
}

// Adds the subcommand that `first` names, or all of them: their options take longer to make than to parse.
void add_subcommands(CLI::App& app, std::string_view first) {
  const auto all = subcommands();
  const auto named = std::find_if(all.begin(), all.end(),
                                  [&](const Subcommand& subcommand) { return subcommand.name == first; });
  if (named != all.end() && first != "completion")
    return named->add(app);  // completion lists the options of all
  for (const Subcommand& subcommand : all) subcommand.add(app);
}

// An empty value is a variable of a script that is not set.
void refuse_empty_values(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      option->check(
          [](const std::string& value) { return value.empty() ? "must not be empty" : std::string(); });
    }
  }
}

int parse_and_run(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) return complain(what_is_missing(app), kWrongArguments);
    return flushed();
  } catch (const CLI::Success& wanted) {  // --help, --version
    const int status = app.exit(wanted);
    return status == 0 ? flushed() : status;
  } catch (const CLI::ParseError& e) {
    // A mistyped option is often the one that is then missing.
    return complain(unexpected_argument(app).value_or(e.what()), kWrongArguments);
  } catch (const ExitStatus& status) {
    return status.value;
  } catch (const Failure& e) {
    return complain(e.what(), e.is_about_option() ? kWrongArguments : kFailed);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", kFailed);
  } catch (const std::filesystem::filesystem_error& e) {
    return complain(e.path1().string() + ": " + e.code().message(), kFailed);
  } catch (const std::exception&) {  // whose text is about the tool's own types
    return complain("an error of the tool itself, which should be reported", kFailed);
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  prepare_process();
  CLI::App app("Phong-shaded 3D in integers: tools for the desk", "arcspan");
  app.set_version_flag("--version", ARCSPAN_VERSION_TEXT);
  app.require_subcommand(0, 1);
  app.footer(
      "`arcspan COMMAND --help` shows a command's options and examples. Results go to standard output or\n"
      "into files, progress and complaints to standard error. Exit status: 0; 1 for what is wrong with\n"
      "files, meshes or their formats, or a comparison that fails; 2 for wrong arguments.");
  add_subcommands(app, argc > 1 ? argv[1] : "");
  refuse_empty_values(app);
  app.allow_extras();  // for the root only, so that an unknown subcommand can be named
  return parse_and_run(app, argc, argv);
}

}  // namespace arcspan::tools
