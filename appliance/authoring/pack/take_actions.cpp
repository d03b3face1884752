#include "appliance/authoring/pack/take_actions.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/record/take.h"
#include "appliance/authoring/takes/edit.h"
#include "appliance/authoring/takes/take_file.h"
#include "appliance/programs/report/logged_show.h"
#include "drivers/base/folder.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"

namespace kaori::authoring {
namespace {

// The words behind the action, which all begin with a show's folder and, but for `list`, the take that is
// made or changed.
constexpr std::size_t kFolder = 1, kName = 2;

// Both bounds are included. Errors: invalid_argument, with the word and the bounds.
Result<float> NumberOf(const std::string& word, float least, float most) {
  const auto number = ParseNumber<float>(word);
  if (number && *number >= least && *number <= most) return *number;
  return FailInput(fmt::format("{}: a number from {} to {} is expected", word, least, most));
}

// A typing error in the path must not make a folder "takes" anywhere else, so that show.toml is looked for.
Result<std::filesystem::path> ShowFolder(const Arguments& arguments) {
  std::filesystem::path folder = arguments.words[kFolder];
  if (!IsThere(folder / "show.toml"))
    return FailInput(folder.string() + ": it is no folder of a show: it has no show.toml");
  return folder;
}

// What a new take may be called. One that is there is not written over by accident.
Result<void> CheckName(const std::filesystem::path& folder, const Arguments& arguments) {
  const std::string& name = arguments.words[kName];
  if (!IsTakeName(name))
    return FailInput(
        fmt::format("\"{}\": a take's name is of letters, digits, spaces, - and _, and is not \"{}\"", name,
                    kNoTakeName));
  if (!arguments.Has("--replace") && IsThere(FileOfTake(folder, name)))
    return FailInput(
        fmt::format("{}: it is there; --replace takes its place", FileOfTake(folder, name).string()));
  return {};
}

// The answer is the file's path and a description of the take, so that a slip in a number is seen at once.
Said Save(const std::filesystem::path& folder, const Take& take) {
  if (auto ok = SaveTake(folder, take); !ok) return tl::unexpected(ok.error());
  return fmt::format("{}: {}", FileOfTake(folder, take.name).string(), Described(take));
}

// "19:43:10.5", as the clock of the evening had it.
Result<Time> MomentOf(const showlog::LogFile& log, std::string_view text) {
  // The fraction of a second is read apart, since the log's clock knows whole seconds of a day only.
  const std::size_t dot = std::min(text.find('.'), text.size());
  const auto whole = log.AtDayTime(text.substr(0, dot));
  const auto part_s =
      dot == text.size() ? std::optional(0.0) : ParseNumber<double>("0" + std::string(text.substr(dot)));
  if (whole && part_s) return *whole + FromSeconds(*part_s);
  return FailInput(fmt::format("{}: a time of day is expected, as in 19:43:10.5", text));
}

// "FROM..TO" within the log.
Result<RecordOptions> StretchOf(const showlog::LogFile& log, const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos)
    return FailInput(fmt::format("{}: two times of day are expected, as in 19:43:10..19:43:18", text));
  const auto from = MomentOf(log, std::string_view(text).substr(0, dots));
  if (!from) return tl::unexpected(from.error());
  const auto to = MomentOf(log, std::string_view(text).substr(dots + 2));
  if (!to) return tl::unexpected(to.error());
  const double length_s = Seconds(*to - *from);
  if (!(length_s >= kShortestTake_s && length_s <= show::kLongestMotion_s))
    return FailInput(fmt::format("{}: {:.1f} s long, and {} to {} s can be recorded", text, length_s,
                                 kShortestTake_s, show::kLongestMotion_s));
  return RecordOptions{.from = *from, .to = *to};
}

// The empty text stands for an option that was not given: no option of this verb has a use for one.
std::string OptionOf(const Arguments& arguments, const std::string& name) {
  const auto option = arguments.options.find(name);
  return option == arguments.options.end() ? "" : option->second;
}

Said Record(const Arguments& arguments) {
  const auto folder = ShowFolder(arguments);
  if (!folder) return tl::unexpected(folder.error());
  if (auto ok = CheckName(*folder, arguments); !ok) return tl::unexpected(ok.error());
  const auto log = showlog::LogFile::Read(arguments.words[4]);
  if (!log) return tl::unexpected(log.error());
  // A damaged part of the log is no reason to refuse: the stretch that is wanted may lie elsewhere.
  for (const std::string& fault : log->faults()) LogWarning("{}", fault);
  auto options = StretchOf(*log, arguments.words[5]);
  if (!options) return tl::unexpected(options.error());
  const auto show = report::LoadShowOfLog(arguments.words[3], log->head(), OptionOf(arguments, "--own"));
  if (!show) return tl::unexpected(show.error());
  options->name = arguments.words[kName];
  // StretchOf knows the two times alone: all else comes from the options of the command line.
  options->with = OptionOf(arguments, "--with");
  options->mouth = arguments.Has("--mouth");
  if (const std::string role = OptionOf(arguments, "--role"); !role.empty()) {
    const auto levels = LevelsOfRole(*show, role);
    if (!levels) return FailInput(fmt::format("--role {}: the show has no such role", role));
    options->levels = *levels;
  }
  const auto take = RecordTake(*log, *show, *options);
  if (!take) return tl::unexpected(take.error());
  return Save(*folder, *take);
}

// Loads a take, has `change(take)` change it, and saves it. `change` may give an error.
template <class Change>
Said Changed(const Arguments& arguments, Change change) {
  const auto folder = ShowFolder(arguments);
  if (!folder) return tl::unexpected(folder.error());
  auto take = LoadTake(*folder, arguments.words[kName]);
  if (!take) return tl::unexpected(take.error());
  if (Result<void> ok = change(*take); !ok) return tl::unexpected(ok.error());
  return Save(*folder, *take);
}

// Sets a number of a take to the third word.
Said SetTo(const Arguments& arguments, float Take::*member, float least, float most) {
  return Changed(arguments, [&](Take& take) -> Result<void> {
    const auto number = NumberOf(arguments.words[3], least, most);
    if (!number) return tl::unexpected(number.error());
    take.*member = *number;
    return {};
  });
}

Said Trim(const Arguments& arguments) {
  return Changed(arguments, [&](Take& take) -> Result<void> {
    const auto from_s = NumberOf(arguments.words[3], 0, show::kLongestMotion_s);
    if (!from_s) return tl::unexpected(from_s.error());
    take.from_s = *from_s;
    // Without an end the take is played to the end of its recording.
    take.to_s.reset();
    if (arguments.words[4] == "end") return {};
    const auto to_s = NumberOf(arguments.words[4], 0, show::kLongestMotion_s);
    if (!to_s) return tl::unexpected(to_s.error());
    take.to_s = *to_s;
    return {};
  });
}

Said Stretch(const Arguments& arguments) {
  return SetTo(arguments, &Take::stretch, kFastestTake, kSlowestTake);
}

Said Amplify(const Arguments& arguments) {
  return SetTo(arguments, &Take::gain, show::kLeastTakeGain, show::kMostTakeGain);
}

Said Ease(const Arguments& arguments) {
  return SetTo(arguments, &Take::ease_s, kShortestEase_s, kLongestEase_s);
}

Said Put(const Arguments& arguments) {
  return Changed(arguments, [&](Take& take) -> Result<void> {
    const std::string& name = arguments.words[3];
    const auto* const found = std::ranges::find(show::kMotionLayerNames, name);
    if (found == show::kMotionLayerNames.end())
      return FailInput(fmt::format("{}: is none of {}", name, fmt::join(show::kMotionLayerNames, ", ")));
    take.layer = static_cast<show::MotionLayer>(found - show::kMotionLayerNames.begin());
    return {};
  });
}

Said Loop(const Arguments& arguments) {
  return Changed(arguments, [&](Take& take) -> Result<void> {
    // The blend keeps its value while the loop is off.
    take.loop = arguments.words[3] != "off";
    if (!take.loop) return {};
    const auto blend_s = NumberOf(arguments.words[3], kShortestBlend_s, kLongestBlend_s);
    if (!blend_s) return tl::unexpected(blend_s.error());
    take.blend_s = *blend_s;
    return {};
  });
}

// Loads the two takes and saves what `make(first, second)` makes of them.
template <class Make>
Said Combined(const Arguments& arguments, Make make) {
  const auto folder = ShowFolder(arguments);
  if (!folder) return tl::unexpected(folder.error());
  if (auto ok = CheckName(*folder, arguments); !ok) return tl::unexpected(ok.error());
  const auto first = LoadTake(*folder, arguments.words[3]);
  if (!first) return tl::unexpected(first.error());
  const auto second = LoadTake(*folder, arguments.words[4]);
  if (!second) return tl::unexpected(second.error());
  if (!first->sound.empty() && (first->from_s != 0 || first->to_s))
    return FailInput(fmt::format(
        "\"{}\" is trimmed and has a sound, which would begin elsewhere: trim the new take instead",
        first->name));
  Result<Take> made = make(*first, *second);
  if (!made) return tl::unexpected(made.error());
  made->name = arguments.words[kName];
  if (made->name != first->name) made->key.clear();  // One key plays one take.
  return Save(*folder, *made);
}

Said Layer(const Arguments& arguments) {
  return Combined(arguments, [](const Take& first, const Take& second) -> Result<Take> {
    return Layered(first, second);
  });
}

Said Punch(const Arguments& arguments) {
  return Combined(arguments, [&](const Take& first, const Take& second) -> Result<Take> {
    const auto at_s = NumberOf(arguments.words[5], 0, PlayedLength(first));
    if (!at_s) return tl::unexpected(at_s.error());
    return PunchedIn(first, second, *at_s);
  });
}

// One line for each, faults too: a list is what one looks at when something is wrong.
Said List(const Arguments& arguments) {
  const auto folder = ShowFolder(arguments);
  if (!folder) return tl::unexpected(folder.error());
  std::vector<std::string> lines;
  for (const auto& path : ListFolder(*folder / "takes").value_or(std::vector<std::filesystem::path>{})) {
    if (path.extension() != ".toml") continue;
    const auto take = LoadTake(*folder, path.stem().string());
    lines.push_back(take ? fmt::format("{}: {}{}{}", take->name, Described(*take),
                                       take->notes.empty() ? "" : "; ", take->notes)
                         : take.error().message());
  }
  std::ranges::sort(lines);
  return lines.empty() ? fmt::format("{} has no takes", folder->string())
                       : fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace

std::span<const TakeAction> ActionsOnTakes() {
  static const std::array<TakeAction, 10> actions{
      {{"record",
        "FOLDER NAME PACK LOG FROM..TO",
        {"--with", "--role", "--mouth", "--own", "--replace"},
        Record},
       {"trim", "FOLDER NAME FROM TO|end", {}, Trim},
       {"stretch", "FOLDER NAME FACTOR", {}, Stretch},
       {"gain", "FOLDER NAME FACTOR", {}, Amplify},
       {"ease", "FOLDER NAME SECONDS", {}, Ease},
       {"loop", "FOLDER NAME SECONDS|off", {}, Loop},
       {"put", "FOLDER NAME under|over|add", {}, Put},
       {"layer", "FOLDER NAME FIRST SECOND", {"--replace"}, Layer},
       {"punch", "FOLDER NAME FIRST SECOND AT", {"--replace"}, Punch},
       {"list", "FOLDER", {}, List}}};
  return actions;
}

}  // namespace kaori::authoring
