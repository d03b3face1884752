#include "appliance/core/store/play_log.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "drivers/base/read_file.h"

namespace kaori::store {
namespace {

// More than count in a minute; the log stays small through an evening of ends.
constexpr std::size_t kMostKept = 16;
constexpr std::size_t kMostLog_bytes = 1 << 16;

bool Contains(const std::vector<std::string>& shows, const std::string& show) {
  return std::ranges::find(shows, show) != shows.end();
}

// Ends that lie at the same moment as now count: the stage that starts after the third is the one that asks.
bool EndedSoOften(const PlayLog& log, const std::string& show, Time now, int most) {
  if (log.unsettled >= most && !log.ends.empty() && log.ends.back().show == show) return true;
  return std::ranges::count_if(log.ends, [&](const PlayLog::End& end) {
           return end.show == show && now - end.at <= kEndsWithin;
         }) >= most;
}

}  // namespace

// The service manager starts a stage that ended at once again, so that the end is told by the next start.
PlayLog Started(PlayLog log, const Choice& choice, Time now) {
  if (log.generation != choice.generation) {
    PlayLog fresh;
    fresh.generation = choice.generation;
    fresh.last = log.last;
    log = std::move(fresh);
  }
  const bool settled = std::exchange(log.settled, false);
  const std::string ended = std::exchange(log.playing, {});
  if (settled) log.unsettled = 0;
  if (ended.empty()) return log;
  if (!settled) log.unsettled = 1 + (!log.ends.empty() && log.ends.back().show == ended ? log.unsettled : 0);
  if (log.ends.size() >= kMostKept) log.ends.erase(log.ends.begin());
  log.ends.push_back({ended, now});
  if (!IsId(ended) || Contains(log.given_up, ended)) return log;
  if (!EndedSoOften(log, ended, now, kMostEnds)) return log;
  log.given_up.push_back(ended);
  return log;
}

bool IsDoubted(const PlayLog& log, const std::string& show, Time now) {
  return EndedSoOften(log, show, now, kDoubtedEnds);
}

std::vector<std::string> ToTry(const PlayLog& log, const Choice& choice) {
  auto order = InOrder(choice);
  order.emplace_back(kCopiedShow);
  std::erase_if(order, [&](const std::string& show) { return IsId(show) && Contains(log.given_up, show); });
  return order;
}

// Each line is a word and a show; numbers follow it. Times are those of the machine since it was started.
std::string Format(const PlayLog& log) {
  std::string text = "generation " + std::to_string(log.generation) + "\n";
  if (!log.playing.empty()) text += "playing " + log.playing + "\n";
  if (!log.last.empty()) text += "last " + log.last + "\n";
  if (log.settled) text += "settled " + log.last + "\n";
  if (log.unsettled > 0) text += "unsettled " + log.last + " " + std::to_string(log.unsettled) + "\n";
  for (const auto& end : log.ends)
    text += "end " + end.show + " " + std::to_string(end.at.time_since_epoch().count()) + "\n";
  for (const auto& show : log.given_up) text += "gave_way " + show + "\n";
  return text;
}

// A line that is not known makes all of it unsound: half a log would blame the wrong show.
PlayLog ParsePlayLog(std::string_view text) {
  std::istringstream words{std::string(text)};
  PlayLog log;
  std::string word, show;
  if (!(words >> word >> log.generation) || word != "generation") return {};
  while (words >> word >> show) {
    if (show != kRootShow && show != kCopiedShow && !IsId(show)) return {};
    Duration::rep at = 0;
    if (word == "playing") {
      log.playing = show;
    } else if (word == "last") {
      log.last = show;
    } else if (word == "settled") {
      log.settled = true;
    } else if (word == "unsettled" && words >> log.unsettled) {
      continue;
    } else if (word == "gave_way") {
      log.given_up.push_back(show);
    } else if (word == "end" && words >> at) {
      log.ends.push_back({show, Time{} + Duration(at)});
    } else {
      return {};
    }
  }
  return log;
}

std::filesystem::path PlayLogBeside(const std::filesystem::path& board) {
  return board.parent_path() / "plays";
}

PlayLog ReadPlayLog(const std::filesystem::path& file) {
  return ParsePlayLog(ReadFile(file, {.most_bytes = kMostLog_bytes}).value_or(""));
}

}  // namespace kaori::store
