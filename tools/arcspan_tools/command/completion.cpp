// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/completion.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

/// Whether a choice stands for itself, unlike a range (`1...4`) or a place for values (`R,G,B`).
bool is_word(const std::string& choice) {
  return choice.find("...") == std::string::npos && choice.find(',') == std::string::npos;
}

/// The words among the choices of a type name such as `flat|gouraud|arc`.
std::vector<std::string> choices_of(const std::string& type) {
  std::vector<std::string> choices;
  for (std::size_t at = 0; type.find('|') != std::string::npos && at <= type.size();) {
    const std::size_t end = std::min(type.find('|', at), type.size());
    const std::string choice = type.substr(at, end - at);
    if (is_word(choice)) choices.push_back(choice);
    at = end + 1;
  }
  return choices;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

bool is_positional(const CLI::Option& option) {
  return option.get_positional() && option.get_lnames().empty() && option.get_snames().empty();
}

std::vector<std::string> words_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    if (!is_positional(*option)) continue;
    for (const std::string& word : choices_of(option->get_type_name())) words.push_back(word);
  }
  return words;
}

std::vector<CompletedOption> options_of(const CLI::App& command) {
  std::vector<CompletedOption> options;
  for (const CLI::Option* option : command.get_options()) {
    const bool is_hidden = option->get_group().empty();
    if (is_positional(*option) || is_hidden) continue;
    CompletedOption found;
    found.help = first_line(option->get_description());
    found.takes_value = option->get_items_expected_max() > 0;
    found.choices = found.takes_value ? choices_of(option->get_type_name()) : std::vector<std::string>{};
    if (!option->get_snames().empty()) found.short_name = "-" + option->get_snames()[0];
    // A flag may have several names, one of them its negation.
    for (const std::string& name : option->get_lnames()) {
      found.long_name = "--" + name;
      options.push_back(found);
      found.short_name.clear();
    }
    if (option->get_lnames().empty()) options.push_back(found);
  }
  return options;
}

std::string spaced(const std::vector<std::string>& words) { return joined(words, " "); }

/// `text` in single quotes.
std::string single_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// `text` for a description in brackets of zsh.
std::string bracketed(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == '\\' || c == ':') out += '\\';
    out += c;
  }
  return out;
}

std::vector<std::string> names_of(const CompletedOption& option) {
  std::vector<std::string> names;
  for (const std::string& name : {option.long_name, option.short_name}) {
    if (!name.empty()) names.push_back(name);
  }
  return names;
}

std::string bash_command(const CompletedCommand& command) {
  std::vector<std::string> names;
  std::string values;
  for (const CompletedOption& option : command.options) {
    for (const std::string& name : names_of(option)) names.push_back(name);
    if (!option.takes_value) continue;
    std::string pattern;
    for (const std::string& name : names_of(option)) pattern += (pattern.empty() ? "" : "|") + name;
    values += "        " + pattern + ") " +
              (option.choices.empty()
                   ? "local IFS=$'\\n'; COMPREPLY=($(compgen -f -- \"$word\"))"
                   : "COMPREPLY=($(compgen -W " + single_quoted(spaced(option.choices)) + " -- \"$word\"))") +
              "; return ;;\n";
  }
  return "    " + command.name + ")\n      case \"$before\" in\n" + values +
         "      esac\n      names=" + single_quoted(spaced(names)) +
         "\n      words=" + single_quoted(spaced(command.words)) + "\n      ;;\n";
}

}  // namespace

std::vector<CompletedCommand> completed_commands(const CLI::App& app) {
  std::vector<CompletedCommand> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back({command->get_name(), first_line(command->get_description()), options_of(*command),
                        words_of(*command)});
  }
  return commands;
}

std::string bash_completion(const std::string& program, const std::vector<CompletedCommand>& commands) {
  std::vector<std::string> names;
  std::string cases;
  for (const CompletedCommand& command : commands) {
    names.push_back(command.name);
    cases += bash_command(command);
  }
  return "# bash completion of " + program + "; made by: " + program + " completion bash\n_" + program +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} names= words=\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W " +
         single_quoted(spaced(names) + " --help --version") +
         " -- \"$word\"))\n    return\n  fi\n"
         "  case \"${COMP_WORDS[1]}\" in\n" +
         cases +
         "  esac\n"
         "  case \"$word\" in\n"
         "    -*) COMPREPLY=($(compgen -W \"$names\" -- \"$word\")) ;;\n"
         "    *) COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "       local IFS=$'\\n'\n"
         "       COMPREPLY+=($(compgen -f -- \"$word\")) ;;\n"
         "  esac\n}\ncomplete -o filenames -F _" +
         program + " " + program + "\n";
}

std::string zsh_completion(const std::string& program, const std::vector<CompletedCommand>& commands) {
  std::string list;
  std::string cases;
  for (const CompletedCommand& command : commands) {
    list += "    " + single_quoted(bracketed(command.name) + ":" + command.help) + "\n";
    cases += "    " + command.name + ")\n      _arguments -S \\\n";
    for (const CompletedOption& option : command.options) {
      for (const std::string& name : names_of(option)) {
        std::string spec = name + "[" + bracketed(option.help) + "]";
        if (option.takes_value) {
          spec += ":value:" + (option.choices.empty() ? "_files" : "(" + spaced(option.choices) + ")");
        }
        cases += "        " + single_quoted("*" + spec) + " \\\n";
      }
    }
    const std::string rest = command.words.empty() ? "_files" : "(" + spaced(command.words) + ")";
    cases += "        '*:file:" + rest + "'\n      ;;\n";
  }
  return "#compdef " + program + "\n# zsh completion of " + program + "; made by: " + program +
         " completion zsh\n_" + program + "() {\n  local -a commands\n  commands=(\n" + list +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
         "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
         "  case $command in\n" +
         cases + "  esac\n}\ncompdef _" + program + " " + program + "\n";
}

std::string fish_completion(const std::string& program, const std::vector<CompletedCommand>& commands) {
  const std::string complete = "complete -c " + program;
  std::string text = "# fish completion of " + program + "; made by: " + program + " completion fish\n";
  for (const CompletedCommand& command : commands) {
    text += complete + " -f -n __fish_use_subcommand -a " + command.name + " -d " +
            single_quoted(command.help) + "\n";
    if (!command.words.empty()) {
      text += complete + " -f -n '__fish_seen_subcommand_from " + command.name + "' -a " +
              single_quoted(spaced(command.words)) + "\n";
    }
    for (const CompletedOption& option : command.options) {
      text += complete + " -n '__fish_seen_subcommand_from " + command.name + "'";
      if (!option.long_name.empty()) text += " -l " + option.long_name.substr(2);
      if (!option.short_name.empty()) text += " -s " + option.short_name.substr(1);
      if (!option.choices.empty()) text += " -f";
      if (option.takes_value) text += " -r";
      if (!option.choices.empty()) text += " -a " + single_quoted(spaced(option.choices));
      text += " -d " + single_quoted(option.help) + "\n";
    }
  }
  return text;
}

}  // namespace arcspan::tools
