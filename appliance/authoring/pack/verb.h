// One verb of kaori-atelier, as a value: its words on the help page, and what it does.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::authoring {

// What stands behind a verb on the command line.
struct Arguments {
  std::vector<std::string> words;              // As many as the verb asks for.
  std::map<std::string, std::string> options;  // "--sign" -> its value; "" for a switch.

  bool Has(const std::string& option) const { return options.contains(option); }
};

struct Option {
  std::string_view name;   // "--sign".
  std::string_view value;  // What it takes, for the help page: "KEYFILE"; empty: a switch.
};

struct Verb {
  std::string_view name;
  std::vector<std::string_view>
      words;  // What it is called with: "FOLDER", "FILE"; last, "FILE...": one or more.
  std::vector<Option> options;
  std::string_view summary;                // One line for the list of verbs.
  std::string_view page;                   // What else there is to say, for its own page.
  int (*run)(const Arguments& arguments);  // Returns the exit status: 0, or 1 after it has said why.
};

// "pack FOLDER FILE [--sign KEYFILE]".
std::string UsageOf(const Verb& verb);

// Errors: invalid_argument (a word too few or too many, an unknown option, one without its value).
Result<Arguments> ParseArguments(const Verb& verb, std::span<char* const> args);

// Runs the verb that the command line names, or prints the page it asks for. Returns the exit status; 2 where
// the command line makes no sense.
int Dispatch(std::span<const Verb> verbs, std::span<char* const> args);

}  // namespace kaori::authoring
