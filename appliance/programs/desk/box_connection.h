// The desk's end of the connection to kaori-shows: the list of the box and its settings come in as one text, which goes on to the
// page, and what a visitor asks for goes out (shows/protocol).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::desk {

// Used by one thread; nothing blocks. While kaori-shows is away it tries to connect twice a second.
class BoxConnection {
 public:
  // `path` is that of kaori-shows' socket; nothing is connected yet.
  explicit BoxConnection(std::string path) : path_(std::move(path)) {}

  // Connects, and reads what waits. Call it every 20 ms or sooner.
  void Step(Time now);

  // The newest state, one line of JSON; nothing while kaori-shows is away.
  const std::optional<std::string>& state() const { return state_; }

  // The newest backup that kaori-shows made for this desk, by its name; a descriptor of its own for whoever fetches it. Errors:
  // no_such_file_or_directory, there is none.
  Result<UniqueFd> OpenBackup() const;
  const std::string& backup_name() const { return backup_name_; }

  // Hands a request of shows/protocol on, with `file` beside it, which is borrowed; -1: none. Errors:
  //   no_such_device                    kaori-shows is away
  //   resource_unavailable_try_again    it reads too slowly; other errors are those of the socket
  Result<void> Send(std::string_view request, int file = -1);

 private:
  // Tries to connect; not again before half a second has passed.
  void Connect(Time now);
  // The newest of the states that wait, of 16 at most.
  void Receive();
  void Disconnect();

  std::string path_;
  UniqueFd socket_;
  std::optional<std::string> state_;
  UniqueFd backup_;
  std::string backup_name_;
  Time retry_at_{};
};

}  // namespace kaori::desk
