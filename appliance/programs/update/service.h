// The answers of kaori-update to kaori-shows (appliance/core/update/caller.h), one request at a time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "appliance/core/update/caller.h"
#include "appliance/programs/update/installation.h"
#include "appliance/programs/update/notes.h"
#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"

namespace kaori::update {

// The partitions of the slot that does not run.
struct Disk {
  std::unique_ptr<ports::BlockDevice> root, verity, boot;
  // Where its kernel lies on `boot`.
  std::uint64_t kernel_at = 0;
  std::uint64_t kernel_bytes = 0;
};

// What an update is for, and how it is reached. Each is opened when it is wanted: nobody holds a disk without need.
struct Box {
  Running running;
  std::function<show::PublicKeys()> keys;
  std::function<Result<Disk>()> open_disk;
  std::function<Result<std::unique_ptr<ports::BootChoice>>()> open_choice;
  // Has the service manager restart the machine; returns before that has begun.
  std::function<void()> restart;
  // Whether an update may be written on now, beside the face; null: always.
  std::function<bool()> may_work{};
};

// One thread; the notes must outlive it.
class UpdateService {
 public:
  UpdateService(UniqueFd listener, Box box, Notes& notes)
      : listener_(std::move(listener)), box_(std::move(box)), notes_(notes) {}

  // To be called every kPeriod: a step copies 1 MiB at most.
  void Step(Time now);
  // Nobody has asked for anything for kPatience: the program may end, and is started again by the next call.
  bool IsIdle(Time now) const { return !client_.valid() && busy_at_ && now - *busy_at_ > kPatience; }

  static constexpr Duration kPeriod = std::chrono::milliseconds(50);
  static constexpr Duration kPatience = std::chrono::seconds(10);

 private:
  // A step is one look at the socket and one piece of the work. Nothing of a request is kept once its client is gone: whoever
  // turned the key back, or pulled the stick and left, has ended it.
  // Whoever called comes first; another one waits until the first has gone.
  void Hear();
  void Handle(std::string_view request, UniqueFd file);
  void Look(UniqueFd file);
  void Begin(UniqueFd file);
  void Restart();
  // The next piece; tells what has changed.
  void StepInstallation();
  void Say(const Answer& answer);

  UniqueFd listener_;
  Box box_;
  Notes& notes_;
  UniqueFd client_;
  // The first Step, or the last one with a client.
  std::optional<Time> busy_at_;
  std::optional<Disk> disk_;
  std::optional<Answer> said_;
  // Writes to the disk, and is gone before it.
  std::optional<Installation> installation_;
};

}  // namespace kaori::update
