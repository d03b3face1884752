#include <algorithm>

#include <fmt/format.h>

#include "appliance/authoring/pack/take_actions.h"
#include "appliance/authoring/pack/verbs.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// What makes no sense of the call; empty: it does.
std::string Misuse(const TakeAction& action, const Arguments& arguments) {
  // Single blanks separate the words of an action: there is one more of them, and its name.
  const auto wanted = static_cast<std::size_t>(std::ranges::count(action.words, ' ')) + 2;
  if (arguments.words.size() != wanted)
    return fmt::format("take {}: it is called as: kaori-atelier take {} {}", action.name, action.name,
                       action.words);
  for (const auto& [option, value] : arguments.options)
    if (std::ranges::find(action.options, option) == action.options.end())
      return fmt::format("take {}: it has no option {}", action.name, option);
  return "";
}

int RunTake(const Arguments& arguments) {
  const auto actions = ActionsOnTakes();
  const auto action = std::ranges::find(actions, arguments.words[0], &TakeAction::name);
  std::string misuse;
  if (action == actions.end())
    misuse = fmt::format(
        "take {}: there is no such action; there are record, trim, stretch, gain, ease, loop, put, layer, "
        "punch, "
        "list",
        arguments.words[0]);
  else
    misuse = Misuse(*action, arguments);
  // The status 2 says that the command line makes no sense, as Dispatch does for all other verbs.
  if (!misuse.empty()) return ExitWithError(FailInput(misuse).value(), 2);
  const Said said = action->run(arguments);
  if (!said) return ExitWithError(said.error());
  fmt::print("{}\n", *said);
  return 0;
}

}  // namespace

Verb VerbOfTakes() {
  return {.name = "take",
          .words = {"ACTION", "WORD..."},
          .options = {{"--with", "NAME"},
                      {"--role", "ROLE"},
                      {"--mouth", ""},
                      {"--own", "FOLDER"},
                      {"--replace", ""}},
          .summary = "makes and changes the takes of a show: what operators played",
          .page = R"(
  take record FOLDER NAME PACK LOG FROM..TO   what operators did between two times of day, as 19:43:10..19:43:18.5
  take trim FOLDER NAME FROM TO|end           what of it is played, in seconds of the recording
  take stretch FOLDER NAME FACTOR             0.25 to 4: 2 is half as fast
  take gain FOLDER NAME FACTOR                0.1 to 2: of all that moves
  take ease FOLDER NAME SECONDS               in and out: it begins and ends at rest
  take loop FOLDER NAME SECONDS|off           again and again; the end runs into the beginning within so many seconds
  take put FOLDER NAME under|over|add         under or over what is played live, or added to it
  take layer FOLDER NAME FIRST SECOND         makes NAME of FIRST, with the channels that SECOND moves
  take punch FOLDER NAME FIRST SECOND AT      makes NAME of FIRST, with SECOND in its place from second AT on
  take list FOLDER                            what there is

FOLDER is a show's; takes lie in FOLDER/takes/NAME.toml and are packed with it. PACK is the show as it was played when LOG was
written. Recordings are kept whole: trim, stretch, gain, ease, loop and put only say how they are played.

  --with NAME    record: begins where the take NAME began to play in that time, for a pass over it
  --role ROLE    record: what that role's levels did, and nothing else
  --mouth        record: the mouth too
  --own FOLDER   record: where the box kept expressions that were made on it
  --replace      takes the place of a take of this name
)",
          .run = RunTake};
}

}  // namespace kaori::authoring
