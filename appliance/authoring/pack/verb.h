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
  // As many as the verb asks for; more where its last one ends with "...".
  std::vector<std::string> words;
  // "--sign" -> its value; "" for a switch.
  std::map<std::string, std::string> options;

  bool Has(const std::string& option) const { return options.contains(option); }
};

// An option of a verb. All are optional and may stand anywhere behind it; of one that is given twice the
// last value counts.
struct Option {
  // "--sign".
  std::string_view name;
  // What it takes, for the help page: "KEYFILE"; empty: a switch.
  std::string_view value;
};

// All text must outlive the program's run: literals.
struct Verb {
  // The word on the command line.
  std::string_view name;
  std::vector<std::string_view>
      words;  // What it is called with: "FOLDER", "FILE"; last, "FILE...": one or more.
  std::vector<Option> options;
  // One line for the list of verbs.
  std::string_view summary;
  // What else there is to say, for its own page; begins and ends with a newline where there is any.
  std::string_view page;
  // Does the work and returns the exit status: 0, or 1 after it has said why.
  int (*run)(const Arguments& arguments);
};

// How it is called: "pack FOLDER FILE [--sign KEYFILE]".
std::string UsageOf(const Verb& verb);

// `args` are what stands behind the verb. Words that begin with "--" are options; the value of one may begin
// so too. Errors: invalid_argument (a word too few or too many, an unknown option, one without its value);
// the attempt is a sentence's end without the verb.
Result<Arguments> ParseArguments(const Verb& verb, std::span<char* const> args);

// Runs the verb that the command line names, or prints the page it asks for ("help", "--help", "-h"; alone or
// behind a verb). `args` are without the program's name. Returns the exit status; 2, with a line on standard
// error, where the command line makes no sense.
int Dispatch(std::span<const Verb> verbs, std::span<char* const> args);

}  // namespace kaori::authoring
