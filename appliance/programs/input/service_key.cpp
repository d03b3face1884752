#include "appliance/programs/input/service_key.h"

#include <algorithm>
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

ServiceKey::ServiceKey(std::filesystem::path file, Time now) : file_(std::move(file)), began_(now) {
  std::error_code none;
  on_ = !file_.empty() && std::filesystem::exists(file_, none);
  if (!on_) return;
  auto since = UnheardSince(file_);
  if (since && *since > now) since.reset();
  until_ = std::max(since.value_or(now), now - kUnheard) + kUnheard;
  if (now >= until_) {
    on_ = false;
    Remove();
  } else if (!since) {
    Write(std::to_string(now.time_since_epoch().count()));
  }
}

// Compared with what was told last, so that a key that stands costs no call of the system.
void ServiceKey::Step(const board::Stamped<board::Lines>& lines, Time now) {
  if (file_.empty()) return;
  SayStarted(now);
  if (is_unheard_) {
    const bool is_heard = lines.source == board::SourceState::kLive && lines.at >= began_;
    if (!is_heard && (!on_ || now < until_)) return;
    is_unheard_ = !is_heard;
    // The file says since when nobody has heard: that is over.
    if (is_heard && on_ && board::IsServiceKeyOn(lines)) Write({});
    if (!is_heard) {
      on_ = false;
      return Remove();
    }
  }
  const bool on = board::IsServiceKeyOn(lines);
  if (on == on_) return;
  on_ = on;
  on ? Write({}) : Remove();
}

// Once a program: one that was started anew writes what is there already.
void ServiceKey::SayStarted(Time now) {
  if (has_started_ || now - began_ < kStart) return;
  has_started_ = true;
  if (auto made = WriteWholeFile(file_.parent_path() / "started", {}); !made)
    LogWarning("a GPIO bridge that is plugged in late is taken for the box's own: {}",
               made.error().message());
}

void ServiceKey::Write(const std::string& unheard_since) const {
  if (auto made = WriteWholeFile(file_, {AsBytes(unheard_since)}); !made)
    LogWarning("the service key has no effect: {}", made.error().message());
}

void ServiceKey::Remove() const {
  std::error_code none;
  std::filesystem::remove(file_, none);
}

}  // namespace kaori::input
