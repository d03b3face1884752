#include "appliance/authoring/pack/verb.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

namespace kaori::authoring {
namespace {

// As many programs do: 1 is a failure of the work, 2 of the call.
constexpr int kMisused = 2;

constexpr std::string_view kHead = "kaori-atelier: makes shows\n\n";
constexpr std::string_view kFoot = R"(
  kaori-atelier VERB --help    more about one verb, and its options

Every fault of the authoring files is named with file, item and reason, all at once. A file is written whole or not
at all. Exit status: 0 done, 1 not done, 2 the command line makes no sense.
)";

// Name and words without its options: those stand on the verb's own page.
std::string CallOf(const Verb& verb) {
  std::string call(verb.name);
  for (const std::string_view word : verb.words) call += fmt::format(" {}", word);
  return call;
}

// Summaries stand in one column, behind the longest call.
std::string HelpPage(std::span<const Verb> verbs) {
  std::size_t width = 0;
  for (const Verb& verb : verbs) width = std::max(width, CallOf(verb).size());
  std::string page(kHead);
  for (const Verb& verb : verbs)
    page += fmt::format("  kaori-atelier {:<{}}  {}\n", CallOf(verb), width, verb.summary);
  return page.append(kFoot);
}

// Usage and summary in one line, then the verb's own text.
std::string VerbPage(const Verb& verb) {
  return fmt::format("kaori-atelier {}: {}\n{}", UsageOf(verb), verb.summary, verb.page);
}

// Says what is wrong with the call; returns the exit status.
int Misused(const std::string& what) {
  fmt::print(stderr, "kaori-atelier: {}\n", what);
  return kMisused;
}

// The word "help" counts only in the place of a verb: behind one it may be the name of a file.
bool AsksForHelp(std::string_view word) {
  return word == "--help" || word == "-h" || word == "help";
}

// Help is asked for before arguments are judged: a call that is not whole is no reason to refuse it.
int RunVerb(const Verb& verb, std::span<char* const> args) {
  if (std::ranges::any_of(args, [](std::string_view a) { return a == "--help" || a == "-h"; })) {
    fmt::print("{}", VerbPage(verb));
    return 0;
  }
  const auto arguments = ParseArguments(verb, args);
  if (arguments) return verb.run(*arguments);
  return Misused(fmt::format("{}: {}; it is called as: kaori-atelier {}", verb.name,
                             arguments.error().attempt, UsageOf(verb)));
}

}  // namespace

std::string UsageOf(const Verb& verb) {
  std::string usage = CallOf(verb);
  for (const Option& option : verb.options)
    usage += option.value.empty() ? fmt::format(" [{}]", option.name)
                                  : fmt::format(" [{} {}]", option.name, option.value);
  return usage;
}

// Words and options may be mixed; an option's value is the argument behind it, whatever it looks like.
Result<Arguments> ParseArguments(const Verb& verb, std::span<char* const> args) {
  Arguments arguments;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const std::string_view arg = args[i];
    // A file of such a name can be given as ./--name.
    if (!arg.starts_with("--")) {
      arguments.words.emplace_back(arg);
      continue;
    }
    const auto option = std::ranges::find(verb.options, arg, &Option::name);
    if (option == verb.options.end()) return FailInput(fmt::format("there is no option {}", arg));
    // A second value replaces the first one; a switch keeps the empty text.
    std::string& value = arguments.options[std::string(arg)];
    if (option->value.empty()) continue;
    if (++i == args.size()) return FailInput(fmt::format("{} wants a {}", arg, option->value));
    value = args[i];
  }
  if (arguments.words.size() < verb.words.size())
    return FailInput(fmt::format("{} is missing", verb.words[arguments.words.size()]));
  const bool takes_more = !verb.words.empty() && verb.words.back().ends_with("...");
  if (arguments.words.size() > verb.words.size() && !takes_more)
    return FailInput(fmt::format("\"{}\" is one word too many", arguments.words[verb.words.size()]));
  return arguments;
}

// Help that was asked for goes to standard output and is a success; help that nobody asked for goes to
// standard error and is none.
int Dispatch(std::span<const Verb> verbs, std::span<char* const> args) {
  // Without a verb the page goes to standard error, since nothing was asked for.
  if (args.empty()) {
    fmt::print(stderr, "{}", HelpPage(verbs));
    return kMisused;
  }
  const std::string_view name = args[0];
  if (AsksForHelp(name)) {
    fmt::print("{}", HelpPage(verbs));
    return 0;
  }
  const auto verb = std::ranges::find(verbs, name, &Verb::name);
  if (verb != verbs.end()) return RunVerb(*verb, args.subspan(1));
  return Misused(fmt::format("there is no verb \"{}\"; kaori-atelier --help lists them", name));
}

}  // namespace kaori::authoring
