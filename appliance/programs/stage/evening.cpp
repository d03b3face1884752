#include "appliance/programs/stage/evening.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "appliance/programs/stage/last_face.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"

namespace kaori::stage {
namespace {

// The state of an evening counts the show's items and its roles' controls: both must be those of then.
Result<void> CheckSame(const showlog::LogHead& head, const EveningOptions& options,
                       const std::filesystem::path& pack, const std::filesystem::path& roles) {
  if (const auto mark = ShowMark(pack); !mark || *mark != head.show)
    return FailInput(options.log + ": it is of another show than " + pack.string());
  // As HeadOfLog has them: a box without roles of its own says nothing.
  if (ReadFile(roles, {.most_bytes = showlog::kMostRoles_bytes}).value_or("") != head.roles)
    return FailInput(fmt::format("{}: the box's own roles were others on that evening than in {}",
                                 options.log, roles.string()));
  return {};
}

}  // namespace

Result<LoggedEvening> OpenEvening(const EveningOptions& options, const std::filesystem::path& pack,
                                  const std::filesystem::path& roles, const show::Show& show) {
  if (options.log.empty()) return LoggedEvening{};
  auto log = showlog::LogFile::Read(options.log);
  if (!log) return tl::unexpected(log.error());
  for (const std::string& fault : log->faults()) LogWarning("{}", fault);
  if (auto ok = CheckSame(log->head(), options, pack, roles); !ok) return tl::unexpected(ok.error());
  LoggedEvening evening{std::make_unique<showlog::LogFile>(std::move(*log)), nullptr};
  const Time begin = evening.log->chunks().front().head.first;
  const auto at = options.at.empty() ? std::optional(begin) : evening.log->AtDayTime(options.at);
  if (!at) return FailInput(fmt::format("--at {}: a time of day is expected, as in 19:43:10", options.at));
  auto play = showlog::MinusOne::Open(*evening.log, show, *at, options.without);
  if (!play) return tl::unexpected(play.error());
  evening.play = std::make_unique<showlog::MinusOne>(std::move(*play));
  Log("the evening of {} is played from {} on, without {}", evening.log->Day(), evening.log->DayTimeText(*at),
      options.without);
  return evening;
}

}  // namespace kaori::stage
