#include "hw-sim/hil/bad_slot.h"

#include <elf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

constexpr std::size_t kRootBlock_bytes = 4096;  // Of EROFS and of dm-verity.
constexpr std::size_t kLargestProgram_bytes = std::size_t{64} << 20U;

// Where in its file a program begins; none where it is no program of 64 bits. ELF-64 (elf(5)): the segment that is loaded there.
std::optional<std::uint64_t> EntryOf(const std::string& program) {
  Elf64_Ehdr head{};
  if (program.size() < sizeof head || !program.starts_with(ELFMAG)) return std::nullopt;
  std::memcpy(&head, program.data(), sizeof head);
  for (std::size_t n = 0; n < head.e_phnum; ++n) {
    Elf64_Phdr part{};
    const std::size_t at = head.e_phoff + n * sizeof part;
    if (at + sizeof part > program.size()) return std::nullopt;
    std::memcpy(&part, program.data() + at, sizeof part);
    const bool is_there = head.e_entry >= part.p_vaddr && head.e_entry < part.p_vaddr + part.p_filesz;
    if (part.p_type == PT_LOAD && is_there) return head.e_entry - part.p_vaddr + part.p_offset;
  }
  return std::nullopt;
}

}  // namespace

// "... verity 1 ROOT TREE 4096 4096 BLOCKS 1 DIGEST HASH SALT".
Result<BadSlot::Verity> BadSlot::ReadVerity(const std::string& image) {
  const auto line = ReadFile(image + "/cmdline-b");
  if (!line) return tl::unexpected(line.error());
  const std::size_t at = line->find(" verity 1 ");
  if (at == line->npos) return FailInput(image + "/cmdline-b names no verified root");
  std::istringstream words(line->substr(at));
  std::string skipped;
  Verity verity;
  words >> skipped >> skipped >> skipped >> verity.tree >> skipped >> skipped >> verity.blocks >> skipped >>
      verity.digest >> verity.hash >> verity.salt;
  if (!words || verity.salt.empty()) return FailInput(image + "/cmdline-b says too little of its root");
  while (!verity.salt.empty() && verity.salt.back() == '"') verity.salt.pop_back();
  return verity;
}

// Read whole: blocks of a program are looked for anywhere in it.
Result<BadSlot> BadSlot::Open(std::string disk, std::string image, std::string folder) {
  auto verity = ReadVerity(image);
  if (!verity) return tl::unexpected(verity.error());
  const auto part = PartitionSpan(disk, "root-b");
  if (!part) return tl::unexpected(part.error());
  const std::uint64_t bytes = std::stoull(verity->blocks) * kRootBlock_bytes;
  if (bytes > part->bytes) return FailInput(disk + " has no room for the image's root in slot B");
  auto root = ReadPart(disk, {.at_bytes = part->at_bytes, .bytes = bytes});
  if (!root) return tl::unexpected(root.error());
  return BadSlot(std::move(disk), std::move(image), std::move(folder), std::move(*verity), std::move(*root));
}

Result<std::string> BadSlot::BytesOf(const std::string& program) const {
  return ReadFile(image_ + "/root/usr/bin/" + program, {.most_bytes = kLargestProgram_bytes});
}

// A file's whole blocks lie in the root as they are. The last part of one may stand elsewhere, and is refused.
Result<void> BadSlot::Put(const std::string& file, std::uint64_t at, std::string_view bytes) {
  for (std::uint64_t block = at / kRootBlock_bytes * kRootBlock_bytes; block < at + bytes.size();
       block += kRootBlock_bytes) {
    if (block + kRootBlock_bytes > file.size())
      return FailInput("that place of the program is in no whole block");
    const std::string_view whole = std::string_view(file).substr(block, kRootBlock_bytes);
    const std::size_t found = root_.find(whole);
    if (found == root_.npos || found % kRootBlock_bytes != 0) return FailInput("slot B has no such program");
    if (root_.find(whole, found + 1) != root_.npos) return FailInput("slot B has that block twice");
    for (std::uint64_t n = std::max(block, at); n < std::min(block + kRootBlock_bytes, at + bytes.size());
         ++n)
      root_[found + (n - block)] = bytes[n - at];
  }
  return {};
}

// Code that is longer than the program's first function goes on over the next one, which is never called.
Result<void> BadSlot::Begin(const std::string& program, std::string_view code) {
  const auto file = BytesOf(program);
  if (!file) return tl::unexpected(file.error());
  const auto entry = EntryOf(*file);
  if (!entry) return FailInput(program + " is no program");
  return Put(*file, *entry, code);
}

// A second place would leave one of them as it was, and the version half bad.
Result<void> BadSlot::Replace(const std::string& program, std::string_view text, std::string_view other) {
  const auto file = BytesOf(program);
  if (!file) return tl::unexpected(file.error());
  const std::size_t at = file->find(text);
  if (at == file->npos || text.size() != other.size() || file->find(text, at + 1) != file->npos)
    return FailInput(fmt::format("{} has \"{}\" not once, or it would become longer", program, text));
  return Put(*file, at, other);
}

// As rootfs/image/pack.py does it: the tree's file has a head, which is the partition's first block.
Result<void> BadSlot::Write() const {
  const std::string root = folder_ + "/bad-root", tree = folder_ + "/bad-tree", log = folder_ + "/verity.log";
  for (const std::string& file : {root, tree}) std::ofstream(file, std::ios::trunc).flush();
  if (auto ok = WritePart(root, 0, root_); !ok) return ok;
  if (auto ok = RunToEnd(
          {"veritysetup", "format", "--hash=" + verity_.digest, "--salt=" + verity_.salt, root, tree}, log);
      !ok)
    return ok;
  constexpr std::string_view kRootHash = "Root hash:";
  const std::string said = ReadFile(log).value_or("");
  const std::size_t at = said.find(kRootHash);
  std::string hash;
  if (at != said.npos) std::istringstream(said.substr(at + kRootHash.size())) >> hash;
  const auto tree_bytes = ReadFile(tree, {.most_bytes = kLargestProgram_bytes});
  if (!tree_bytes || hash.size() != verity_.hash.size())
    return FailInput("veritysetup makes no tree: " + said);
  for (const auto& [name, bytes] : {std::pair{"root-b", &root_}, std::pair{"verity-b", &*tree_bytes}}) {
    const auto part = PartitionStart_bytes(disk_, name);
    if (!part) return tl::unexpected(part.error());
    if (auto ok = WritePart(disk_, *part, *bytes); !ok) return ok;
  }
  const std::string before =
      fmt::format("{} 4096 4096 {} 1 {} ", verity_.tree, verity_.blocks, verity_.digest);
  return ReplaceOnBoot(disk_, before + verity_.hash, before + hash);
}

// In all copies: what a file system has freed may hold an older one.
Result<void> ReplaceOnBoot(const std::string& disk, std::string_view text, std::string_view other) {
  const auto boot = PartitionSpan(disk, "boot");
  if (!boot) return tl::unexpected(boot.error());
  auto bytes = ReadPart(disk, *boot);
  if (!bytes) return tl::unexpected(bytes.error());
  std::size_t count = 0;
  for (std::size_t at = 0; (at = bytes->find(text, at)) != bytes->npos; ++count, at += other.size())
    bytes->replace(at, text.size(), other);
  if (count == 0 || text.size() != other.size())
    return FailInput(fmt::format("the boot partition has no \"{}\" to be replaced", text));
  return WritePart(disk, boot->at_bytes, *bytes);
}

}  // namespace kaori::hil
