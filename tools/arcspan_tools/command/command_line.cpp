// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

namespace arcspan::tools {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongArguments = 2;

int complain(const std::string& what, int status) {
  std::fprintf(stderr, "arcspan: %s\n", what.substr(0, what.find('\n')).c_str());
  return status;
}

int parse_and_run(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& e) {
    return complain(e.what(), kWrongArguments);
  } catch (const ExitStatus& status) {
    return status.value;
  } catch (const Failure& e) {
    return complain(e.what(), kFailed);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", kFailed);
  } catch (const std::exception& e) {
    return complain(e.what(), kFailed);
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app("Phong-shaded 3D in integers: tools for the desk", "arcspan");
  app.set_version_flag("--version", ARCSPAN_VERSION);
  app.require_subcommand(1);
  add_commands(app);
  return parse_and_run(app, argc, argv);
}

}  // namespace arcspan::tools
