// What is said of an update to whoever stands before the box, in English and Japanese: one table.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kaori::update {

// How an update stands, or why there is none. Each has a row in the table.
enum class Message : std::uint8_t {
  // It may be taken: signed, whole by its length, newer than what runs.
  kFits,
  // The whole file is read and checked; nothing is written.
  kReading,
  // The other slot is being written.
  kWriting,
  // It is in the other slot, whole; it waits for a restart.
  kWaits,
  // The box restarts to try it.
  kRestarts,
  // This system is tried: its face is looked at.
  kLooking,
  // It started with its face and is what starts from now on.
  kConfirmed,
  // Another kind of file.
  kNotAnUpdate,
  kNewerForm,
  // Its end is missing.
  kCutOff,
  // Its checksum or its signature does not fit.
  kDamaged,
  // Signed, by a key that the box does not trust.
  kForeign,
  // For another machine, or another layout of the disk.
  kOtherProduct,
  // It is older than what runs.
  kOlder,
  // It is older than what runs allows at all.
  kBelowLeast,
  // It does not fit into the slot.
  kTooLarge,
  // The stick was pulled, cannot be read, or gave something else the second time.
  kPulled,
  // The box's own disk cannot be written, or does not hold what was written.
  kDiskFault,
  // The data partition has no room for a note of it.
  kDataFull,
  // The disk is not laid out as an image lays it out.
  kOtherLayout,
  // The running system is itself being tried.
  kTrialRuns,
  // The machine's firmware keeps no variables.
  kForgets,
  // Nothing waits to be tried.
  kNothingWaits,
  // It was tried as often as it may be.
  kTriedOften,
  // It was tried and gave way.
  kGaveWay,
};
inline constexpr std::size_t kMessageCount = 25;

enum class Language : std::uint8_t { kEnglish, kJapanese };

// One row. UTF-8; at most 90 columns, where a Japanese letter has two.
std::string_view Words(Message message, Language language);

// Whether nothing was done and somebody has to do something about it.
bool IsRefusal(Message message);

// "version 12: WORDS", and "(DETAIL)" behind it where there is one; without a version where that is 0. Pure.
std::string Say(Message message, Language language, std::uint32_t version, std::string_view detail = {});

}  // namespace kaori::update
