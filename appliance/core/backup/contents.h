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

inline constexpr std::string_view kContents = "contents";
// Raised when older programs could not restore a backup any more.
inline constexpr int kBackupVersion = 1;

// Limits of what is believed. A pack has its own (show::kLargestPack_bytes).
inline constexpr std::size_t kMostFiles = 500;
inline constexpr std::size_t kMostContents_bytes = std::size_t{128} << 10U;
inline constexpr std::uint64_t kLargestFile_bytes = std::uint64_t{1} << 20U;
inline constexpr std::uint64_t kLargestReport_bytes = std::uint64_t{128} << 20U;
inline constexpr std::uint64_t kMostReports_bytes = std::uint64_t{256} << 20U;

struct Entry {
  Member member;
  std::string sha256;  // 64 hexadecimal digits.
  friend bool operator==(const Entry&, const Entry&) = default;
};

struct Contents {
  std::string box;   // The name of the box that made it, and
  std::string made;  // when, by its clock: for people.
  std::string show;  // The id of the chosen pack, which is among the files, or store::kRootShow.
  std::vector<Entry> files;
  friend bool operator==(const Contents&, const Contents&) = default;
};

// The causes by which a program tells refused backups apart; people read the words.
inline constexpr std::errc kNoBackup = std::errc::executable_format_error;    // Another kind of file.
inline constexpr std::errc kNewerBackup = std::errc::function_not_supported;  // Of a newer version than this program's.
inline constexpr std::errc kCutOffBackup = std::errc::message_size;           // It ends too early, or goes on too long.
inline constexpr std::errc kOutsideBackup = std::errc::cross_device_link;  // A name that leads out of the box's folders.

// The text, with its SHA-256 at its end, and back. Every path is one of a backup's, and none comes twice. Errors, in words
// that follow on a file's name: kNoBackup, kNewerBackup, kOutsideBackup, file_too_large, invalid_argument (damaged). Pure.
std::string Format(const Contents& contents);
Result<Contents> ParseContents(std::string_view text);

}  // namespace kaori::backup
