#include "appliance/programs/input/service_key.h"

#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::input {
namespace {

// When the first start began that has not heard the line, as nanoseconds in the file; none where the line was heard since.
std::optional<Time> UnheardSince(const std::filesystem::path& file) {
  const auto text = ReadFile(file);
  const auto ns = text ? ParseNumber<std::int64_t>(*text) : std::nullopt;
  return ns ? std::optional(Time(std::chrono::nanoseconds(*ns))) : std::nullopt;
}

}  // namespace

ServiceKey::ServiceKey(std::filesystem::path file, Time now) : file_(std::move(file)) {
  std::error_code none;
  on_ = is_unheard_ = !file_.empty() && std::filesystem::exists(file_, none);
  if (!is_unheard_) return;
  const auto since = UnheardSince(file_);
  until_ = since.value_or(now) + kUnheard;
  if (!since) Write(std::to_string(now.time_since_epoch().count()));
}

// Compared with what was told last, so that a key that stands costs no call of the system.
void ServiceKey::Step(const board::Stamped<board::Lines>& lines, Time now) {
  const bool is_heard = lines.source == board::SourceState::kLive, on = board::IsServiceKeyOn(lines);
  if (file_.empty() || (is_unheard_ && !is_heard && now < until_)) return;
  if (on == on_ && !is_unheard_) return;
  is_unheard_ = false;
  on_ = on;
  if (on) return Write({});
  std::error_code none;
  std::filesystem::remove(file_, none);
}

void ServiceKey::Write(const std::string& unheard_since) const {
  if (auto made = WriteWholeFile(file_, {AsBytes(unheard_since)}); !made)
    LogWarning("the service key has no effect: {}", made.error().message());
}

}  // namespace kaori::input
