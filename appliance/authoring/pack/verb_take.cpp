#include <fmt/format.h>

#include "appliance/authoring/pack/verbs.h"
#include "appliance/authoring/report/take.h"
#include "appliance/programs/stage/logged_show.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// A number within its bounds, and the default where it is not given.
struct TakeNumber {
  const char* option;
  float least, most, otherwise;
};
constexpr TakeNumber kGain{"--gain", 0.1F, 2, 1}, kStretch{"--stretch", 0.25F, 4, 1},
    kEase{"--ease", 0, 5, 0.25F};

// What lies outside its bounds is refused and not held to them: a slip of the keyboard should be seen.
Result<float> NumberOf(const Arguments& arguments, const TakeNumber& wanted) {
  const auto given = arguments.options.find(wanted.option);
  if (given == arguments.options.end()) return wanted.otherwise;
  const auto number = ParseNumber<float>(given->second);
  if (number && *number >= wanted.least && *number <= wanted.most) return *number;
  return FailInput(fmt::format("{} {}: a number from {} to {} is expected", wanted.option, given->second,
                               wanted.least, wanted.most));
}

// A name with a quote would end its text in show.toml (TextOfTake). A stretch of the log is a quarter of the
// longest motion at most, since --stretch may make it four times as long.
Result<TakeOptions> OptionsOf(const Arguments& arguments, const showlog::LogFile& log) {
  TakeOptions options{.name = arguments.words[4]};
  if (options.name.find_first_of("\"\\\n") != std::string::npos)
    return FailInput("a take's name has neither quotes nor backslashes");
  const auto from = log.AtDayTime(arguments.words[2]);
  if (!from)
    return FailInput(fmt::format("{}: a time of day is expected, as in 19:43:10", arguments.words[2]));
  const auto length_s = ParseNumber<float>(arguments.words[3]);
  if (!length_s || !(*length_s >= 0.5F && *length_s <= show::kLongestMotion_s / 4))
    return FailInput(fmt::format("{}: seconds are expected, from 0.5 to {}", arguments.words[3],
                                 show::kLongestMotion_s / 4));
  options.from = *from;
  options.length = FromSeconds(static_cast<double>(*length_s));
  for (const auto& [wanted, into] :
       {std::pair{kGain, &options.gain}, {kStretch, &options.stretch}, {kEase, &options.ease_s}}) {
    const auto number = NumberOf(arguments, wanted);
    if (!number) return tl::unexpected(number.error());
    *into = *number;
  }
  return options;
}

// Standard output is the motion alone, so that it can be appended to show.toml. What is wrong with the log
// elsewhere is a warning: the stretch that is wanted may be whole.
int RunTake(const Arguments& arguments) {
  const auto log = showlog::LogFile::Read(arguments.words[1]);
  if (!log) return ExitWithError(log.error());
  for (const std::string& fault : log->faults()) LogWarning("{}", fault);
  const auto options = OptionsOf(arguments, *log);
  if (!options) return ExitWithError(options.error());
  const auto show = stage::LoadShowOfLog(arguments.words[0], log->head(), {});
  if (!show) return ExitWithError(show.error());
  const auto motion = RecordTake(*log, *show, *options);
  if (!motion) return ExitWithError(motion.error());
  fmt::print("{}", TextOfTake(*motion, *show));
  return 0;
}

}  // namespace

Verb VerbOfTakes() {
  return {.name = "take",
          .words = {"PACK", "LOG", "TIME", "SECONDS", "NAME"},
          .options = {{"--gain", "NUMBER"}, {"--stretch", "NUMBER"}, {"--ease", "SECONDS"}},
          .summary = "a motion of what the operators did in a stretch of a show log",
          .page = R"(
Prints a [[motion]] for show.toml: what the sticks did to head, gaze and brows from that time of day on. A key or a cue plays
it, on top of what operators do. The log runs all evening, so that nothing need be armed before.

  --gain NUMBER     of all that moves, 0.1 to 2
  --stretch NUMBER  of its time, 0.25 to 4; 2 is half as fast
  --ease SECONDS    in and out, 0.25 where it is not given: a motion begins and ends at rest
)",
          .run = RunTake};
}

}  // namespace kaori::authoring
