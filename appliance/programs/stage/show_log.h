// Writes the show log to the disk: whole chunks, every half minute, on a thread of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "appliance/core/showlog/format.h"
#include "appliance/core/showlog/recorder.h"
#include "drivers/base/background_writer.h"
#include "drivers/base/result.h"

namespace kaori::stage {

// A folder of logs, NNNN-YYYYMMDD-HHMMSS.kaorilog: numbered, since a box's clock may be wrong. A stage that
// starts again on the same evening goes on in the newest file. The newest three evenings are kept, and of
// these at most 100 MB; a switch of the box begins an evening. A disk that refuses is told of in one line for
// each cause, and the chunk is dropped: the show goes on.
class ShowLog {
 public:
  static constexpr std::uintmax_t kMost_bytes = 100'000'000;
  static constexpr std::size_t kEvenings = 3;

  // Makes the folder where it is not there, and removes what is too old. Blocks for the disk. Errors: those
  // of the folder.
  static Result<std::unique_ptr<ShowLog>> Open(const std::filesystem::path& folder,
                                               const showlog::LogHead& head);
  // What was noted until then is written, where the recorder was closed.
  ~ShowLog() = default;

  // For the stage, which it must outlive.
  showlog::Recorder& recorder() { return recorder_; }

  // Writes what there is, and waits for the disk. At an orderly end; by the stage's thread.
  void Finish();

  // The file that is written; for tests and for who is told.
  const std::filesystem::path& file() const { return file_; }

 private:
  ShowLog(std::filesystem::path folder, const showlog::LogHead& head);
  // On the writer's thread. Logs what the disk refuses.
  void WriteOut();
  Result<void> Append(std::span<const std::uint8_t> chunk);

  std::filesystem::path folder_;
  std::vector<std::uint8_t> head_;
  Duration booted_at_;
  std::filesystem::path file_;
  std::error_code told_;
  showlog::Recorder recorder_;
  BackgroundWriter writer_;  // Last: it uses all the others.
};

// The head of a log of this process: the program's file and the wall clock are asked for. `show` is the
// pack's mark (ShowMark), `roles` the box's own file of roles, which may not be there. Blocks for the disk.
showlog::LogHead HeadOfLog(std::uint64_t show, const std::filesystem::path& roles, Time now);

}  // namespace kaori::stage
