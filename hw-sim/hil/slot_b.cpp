#include "hw-sim/hil/slot_b.h"

#include <algorithm>
#include <array>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/boot_files.h"
#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

// Of a root or its hash tree: a partition has 384 MiB. A kernel's file is smaller.
constexpr std::size_t kMostOfSlot_bytes = std::size_t{384} << 20U;

// A part of slot B: a partition of its own, or a file of the partition boot where `partition` is nothing.
struct PartOfB {
  const char* name;  // For people.
  const char* partition;
  const char* image;  // Below the image's folder: the file that it is made of.
};
constexpr std::array kPartsOfB{PartOfB{"root-b", "root-b", "/root.erofs"},
                               PartOfB{"verity-b", "verity-b", "/root.verity"},
                               PartOfB{"kaori-b.efi", nullptr, "/boot/EFI/Linux/kaori-b.efi"}};

Result<std::vector<DiskSpan>> PlacesOf(const std::string& disk, const PartOfB& part) {
  if (part.partition == nullptr) return BootFile(disk, {"EFI        ", "LINUX      ", "KAORI-B EFI"});
  return PartitionSpan(disk, part.partition).map([](const DiskSpan& span) { return std::vector{span}; });
}

// What the disk has there, as far as `most_bytes`: a partition is larger than what is in it.
Result<std::string> ContentOf(const std::string& disk, const std::vector<DiskSpan>& places,
                              std::size_t most_bytes) {
  std::string content;
  for (DiskSpan span : places) {
    span.bytes = std::min<std::uint64_t>(span.bytes, most_bytes - content.size());
    auto read = ReadPart(disk, span);
    if (!read) return read;
    content += *read;
  }
  return content;
}

}  // namespace

Result<std::vector<DiskSpan>> SlotB(const std::string& disk) {
  std::vector<DiskSpan> all;
  for (const PartOfB& part : kPartsOfB) {
    auto its = PlacesOf(disk, part);
    if (!its) return its;
    all.insert(all.end(), its->begin(), its->end());
  }
  return all;
}

// loader.conf has a short name of which no other file of an image has the beginning.
Result<std::vector<DiskSpan>> PlacesOfAnUpdate(const std::string& disk) {
  auto places = SlotB(disk);
  auto settings = BootFile(disk, {"LOADER     ", "LOADER~1CON"});
  const auto data = PartitionSpan(disk, "data");
  if (!places) return places;
  if (!settings) return settings;
  if (!data) return tl::unexpected(data.error());
  places->insert(places->end(), settings->begin(), settings->end());
  places->push_back(*data);
  return places;
}

Result<void> WantWholeSlotB(const std::string& disk, const std::string& image) {
  for (const PartOfB& part : kPartsOfB) {
    const auto wanted = ReadFile(image + part.image, {.most_bytes = kMostOfSlot_bytes});
    if (!wanted) return tl::unexpected(wanted.error());
    const auto places = PlacesOf(disk, part);
    if (!places) return tl::unexpected(places.error());
    const auto there = ContentOf(disk, *places, wanted->size());
    if (!there) return tl::unexpected(there.error());
    if (*there != *wanted) return FailInput(std::string(part.name) + " is not what the image was made of");
  }
  return {};
}

}  // namespace kaori::hil
