// The lips' end of the line to a desk: commands in, reports and small pictures out, and never a wait.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "appliance/programs/lips/paint_key.h"
#include "appliance/programs/lips/service/words.h"
#include "drivers/base/clock.h"
#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// The newest desk replaces an older one. One that is slow, dead or wrong loses what it misses, or its line;
// the lips lose nothing. Pictures are drawn only while somebody asks for them, 15 a second at most.
class Outlet {
 public:
  // Listens at `path`. Errors: those of the socket.
  static Result<Outlet> Open(const std::string& path);
  Outlet(Outlet&&) = default;
  Outlet& operator=(Outlet&&) = delete;
  ~Outlet();

  // What was asked since; looks and returns are done here.
  std::vector<Command> Hear(Time now);

  // Sends the report when it is news, and ten times a second.
  void Tell(const Report& report, Time now);

  // Sends a small picture where one is wanted and due.
  void Show(const decode::Planes& planes, const PaintKey& key, Time now);

  std::uint32_t shown() const { return number_; }  // Pictures that left.

 private:
  Outlet(UniqueFd listener, std::string path) : listener_(std::move(listener)), path_(std::move(path)) {}
  void Accept();
  void Obey(const Command& command, Time now);
  bool Send(const std::vector<std::uint8_t>& packet, int descriptor = -1);

  UniqueFd listener_;
  std::string path_;
  UniqueFd peer_;
  SharedMemory pictures_;
  std::array<bool, kPictureSlots> lent_{};
  std::uint32_t number_ = 0;
  Time look_until_{};
  Time shown_at_{};
  Time told_at_{};
  Report told_;
};

}  // namespace kaori::lips
