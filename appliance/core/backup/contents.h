// The list of contents of a backup, NAME.kaorishow: whose it is, which show was chosen, and every file with its SHA-256.
//
// A backup is a tar archive (ustar.h). Its first member is the list, `contents`; the others follow in the list's order and
// lie below the paths that they have on a data partition (core/restore/kept.h). An archive of a known format, so that people
// can look into it and unpack it on any computer, also where there is no box and no tool of ours any more; and not
// FlatBuffers, since a show may be larger than a box's free memory and is copied piece by piece.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/backup/ustar.h"

namespace kaori::backup {

// The path of the list in the archive. No file of a box has it.
inline constexpr std::string_view kContents = "contents";
// Raised when older programs could not restore a backup any more.
inline constexpr int kBackupVersion = 1;

// Limits of what is believed. A pack has its own (show::kLargestPack_bytes). A list of so many files with the longest paths is
// within its own limit.
inline constexpr std::size_t kMostFiles = 500;
inline constexpr std::size_t kMostContents_bytes = std::size_t{128} << 10U;
// Far more than settings, expressions, roles or a calibration of anybody have.
inline constexpr std::uint64_t kLargestFile_bytes = std::uint64_t{1} << 20U;
// A box keeps three evenings, of 100 MB together (programs/stage/show_log.h), and may have begun another file.
inline constexpr std::uint64_t kLargestReport_bytes = std::uint64_t{128} << 20U;
inline constexpr std::uint64_t kMostReports_bytes = std::uint64_t{256} << 20U;

// A file as the list has it: "SHA256 BYTES PATH" in a line.
struct Entry {
  Member member;
  // 64 hexadecimal digits.
  std::string sha256;
  friend bool operator==(const Entry&, const Entry&) = default;
};

// The whole list. Its first lines are "kaori-backup VERSION", "box", "made" and "show", its last one its own checksum.
struct Contents {
  // The name of the box that made it, and
  std::string box;
  // when, by its clock: for people.
  std::string made;
  // The id of the chosen pack, which is among the files, or store::kRootShow.
  std::string show;
  // In the archive's order; no path twice, the chosen show's pack and no other one.
  std::vector<Entry> files;
  friend bool operator==(const Contents&, const Contents&) = default;
};

// The causes by which a program tells refused backups apart; people read the words.
// Another kind of file.
inline constexpr std::errc kNoBackup = std::errc::executable_format_error;
// Of a newer version than this program's.
inline constexpr std::errc kNewerBackup = std::errc::function_not_supported;
// It ends too early, or goes on too long.
inline constexpr std::errc kCutOffBackup = std::errc::message_size;
// A name that leads out of the box's folders, or is none of theirs.
inline constexpr std::errc kOutsideBackup = std::errc::cross_device_link;

// The text, with its SHA-256 at its end, and back. Every path is one of a backup's, and none comes twice. Errors, in words
// that follow on a file's name: kNoBackup, kNewerBackup, kOutsideBackup, file_too_large, invalid_argument (damaged). Pure.
std::string Format(const Contents& contents);
Result<Contents> ParseContents(std::string_view text);

}  // namespace kaori::backup
