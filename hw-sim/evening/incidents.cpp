#include "hw-sim/evening/incidents.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drivers/base/unique_fd.h"

namespace kaori::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKept = ".kept";  // The name of a log while its disk is full.
constexpr std::size_t kNoise_bytes = 64;     // Over the head of the board's file.

// The value of a file system's error is an errno, so that it can be told as one.
Result<void> Done(const std::error_code& error, const std::string& attempt) {
  if (error) return Fail(static_cast<std::errc>(error.value()), attempt);
  return {};
}

}  // namespace

// A log that is still under its other name would be missing when the logs are played again.
Incidents::~Incidents() {
  static_cast<void>(FreeDisk());
}

Result<void> Incidents::Make(const Incident& incident) {
  const std::string port(PortName(incident.port));
  const auto count = static_cast<std::size_t>(incident.count);
  switch (incident.kind) {
    case Incident::Kind::kCall:
      return Call(incident.words, 1);
    case Incident::Kind::kFlood:
      return Call(kNothing, incident.count);  // Only room on the board is used up.
    case Incident::Kind::kTear:
      return rehearsal_.rig().SendTorn(port, count);
    case Incident::Kind::kGarbage:
      return rehearsal_.rig().SendRaw(port, std::vector<std::uint8_t>(count, 0xFF));
    case Incident::Kind::kEnd:
      rehearsal_.End(incident.program);
      return {};
    case Incident::Kind::kStart:
      return rehearsal_.Start(incident.program);
    case Incident::Kind::kBoardRemove:
    case Incident::Kind::kBoardCut:
    case Incident::Kind::kBoardOverwrite:
      return SpoilBoard(incident.kind);
    case Incident::Kind::kDiskFill:
      return FillDisk();
    case Incident::Kind::kDiskFree:
      return FreeDisk();
    case Incident::Kind::kFreeze:
      rehearsal_.StandStill(incident.length);
      return {};
  }
  return {};
}

// Calls that follow each other within one step reach the board before its next frame.
Result<void> Incidents::Call(const std::string& words, int times) {
  for (int i = 0; i < times; ++i)
    if (auto called = page_.Call(words); !called) return called;
  return {};
}

// The file is spoilt behind the back of its writers, as a damaged memory or a wrong program would do it.
Result<void> Incidents::SpoilBoard(Incident::Kind how) {
  const fs::path file = rehearsal_.board().path();
  std::error_code error;
  if (how == Incident::Kind::kBoardRemove) {
    fs::remove(file, error);
    return Done(error, "remove " + file.string());
  }
  if (how == Incident::Kind::kBoardCut) {
    fs::resize_file(file, fs::file_size(file, error) / 2, error);
    return Done(error, "cut " + file.string());
  }
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  std::array<std::uint8_t, kNoise_bytes> noise{};
  // Any pattern but that of a valid head does.
  noise.fill(0xA5);
  if (!fd.valid() || ::pwrite(fd.get(), noise.data(), noise.size(), 0) < 0)
    return FailErrno("overwrite " + file.string());
  return {};
}

// Every write to /dev/full fails with ENOSPC (full(4)): no real disk needs to be filled.
Result<void> Incidents::FillDisk() {
  if (!full_.empty()) return {};
  const fs::path file = log_.file();
  std::error_code error;
  // Where nothing is written yet there is nothing to keep.
  if (fs::exists(file, error)) fs::rename(file, file.string() + std::string(kKept), error);
  if (!error) fs::create_symlink("/dev/full", file, error);
  if (error) return Done(error, "fill the disk of " + file.string());
  full_ = file;
  return {};
}

// The kept log gets its name back, so that it is played again with the others.
Result<void> Incidents::FreeDisk() {
  if (full_.empty()) return {};
  const std::string kept = full_.string() + std::string(kKept);
  std::error_code error;
  fs::remove(full_, error);
  if (!error && fs::exists(kept, error)) fs::rename(kept, full_, error);
  return Done(error, "free the disk of " + std::exchange(full_, {}).string());
}

}  // namespace kaori::sim
