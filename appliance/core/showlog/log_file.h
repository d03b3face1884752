// Reads a show log, whole or torn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/showlog/format.h"
#include "drivers/base/result.h"

namespace kaori::showlog {

// A whole chunk of a file.
struct Chunk {
  ChunkHead head;
  std::size_t at_byte = 0;  // In the file.
  std::span<const std::uint8_t> frames;
};

// One file in memory. What of it is spoilt is named in faults(), and the rest is there.
class LogFile {
 public:
  // Blocks for the disk. Errors: those of ReadFile; bad_message (kInput): it is no log, its head is torn, it
  // is of another version of the programs, or no chunk of it is whole.
  static Result<LogFile> Read(const std::filesystem::path& file);
  LogFile(LogFile&&) = default;  // Its bytes stay where they are.
  LogFile& operator=(LogFile&&) = default;
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  const LogHead& head() const { return head_; }
  const std::vector<Chunk>& chunks() const { return chunks_; }
  // One line for each place that is spoilt or missing: the file, the byte and the time of day.
  const std::vector<std::string>& faults() const { return faults_; }

  // The time of day at the box, since midnight of the day on which the log begins.
  Duration DayTime(Time at) const;
  // The same as people write it: "19:43:10".
  std::string DayTimeText(Time at) const;
  // The moment of "19:43:10" or "19:43": the first one after the log's begin. Nothing where the text is no
  // time of day.
  std::optional<Time> AtDayTime(std::string_view text) const;
  // The day on which the log begins: "2026-11-22".
  std::string Day() const;

 private:
  LogFile(std::string file, LogHead head) : file_(std::move(file)), head_(std::move(head)) {}
  // Finds the whole chunks behind the head, and names what lies between them.
  void FindChunks(std::size_t at, const std::string& name);

  std::string file_;  // Its bytes, into which the chunks point: longer than what a string holds in itself.
  LogHead head_;
  std::vector<Chunk> chunks_;
  std::vector<std::string> faults_;
};

}  // namespace kaori::showlog
