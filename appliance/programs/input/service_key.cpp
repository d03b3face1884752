#include "appliance/programs/input/service_key.h"

#include <system_error>
#include <utility>

#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::input {

ServiceKey::ServiceKey(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code none;
  if (!file_.empty()) std::filesystem::remove(file_, none);
}

// Without the program nobody knows how the key stands: it counts as off.
ServiceKey::~ServiceKey() {
  std::error_code none;
  if (!file_.empty()) std::filesystem::remove(file_, none);
}

// Compared with what was told last, so that a key that stands costs no call of the system.
void ServiceKey::Step(const board::Stamped<board::Lines>& lines) {
  const bool on = board::IsServiceKeyOn(lines);
  if (file_.empty() || on == on_) return;
  on_ = on;
  std::error_code none;
  if (!on) {
    std::filesystem::remove(file_, none);
  } else if (auto made = WriteWholeFile(file_, {}); !made) {
    LogWarning("the service key has no effect: {}", made.error().message());
  }
}

}  // namespace kaori::input
