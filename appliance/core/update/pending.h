// The note of an update that lies in the other slot, whole, and waits to be tried.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/ports/boot_choice.h"

namespace kaori::update {

// Where a box keeps it, on the data partition; kaori-update writes it, kaori-shows reads it.
inline constexpr const char* kPendingFile = "/var/lib/kaori/update/pending";

// The same three words of the system that the last update was brought in beside, or tried from, as long as it lies in its slot; its
// tries say nothing.
inline constexpr const char* kBeforeFile = "/var/lib/kaori/update/before";

// An update that is whole in its slot.
struct Pending {
  std::uint32_t version = 0;
  ports::Slot slot = ports::Slot::kB;
  // How often it was tried; a try that was cut off counts.
  std::uint32_t tries = 0;
  friend bool operator==(const Pending&, const Pending&) = default;
};

// One line, "12 B 1", and back; nothing for a text that is anything else. Pure.
std::string Format(const Pending& pending);
std::optional<Pending> ParsePending(std::string_view text);

// The note in a file; nothing where it is not there, or is anything else. Blocks for the disk.
std::optional<Pending> ReadPending(const std::filesystem::path& file);

}  // namespace kaori::update
