// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/command.hpp>

int main(int argc, char** argv) { return arcspan::tools::run_command_line(argc, argv); }
