#include "appliance/programs/desk/brought_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <utility>

namespace kaori::desk {

// O_TMPFILE: nothing is left of it by any end of the desk.
Result<void> BroughtFile::Add(std::uint64_t at, std::string_view part) {
  if (at == 0) {
    bytes_ = 0;
    file_ = UniqueFd(folder_.empty() ? -1 : ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
    if (!file_.valid()) return FailErrno("keep what a visitor brings");
  }
  if (!file_.valid() || at != bytes_ || bytes_ + part.size() > kMost_bytes)
    return FailInput("this part was not expected");
  while (!part.empty()) {
    const ssize_t put = ::write(file_.get(), part.data(), part.size());
    if (put < 0) return FailErrno("keep what a visitor brings");
    part.remove_prefix(static_cast<std::size_t>(put));
    bytes_ += static_cast<std::uint64_t>(put);
  }
  return {};
}

UniqueFd BroughtFile::Release() {
  bytes_ = 0;
  return std::exchange(file_, UniqueFd());
}

}  // namespace kaori::desk
