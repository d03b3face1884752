// Which of the shows on a box is played: the choice among the packs on the data partition and the one in the
// root.
//
// The folder of shows (/var/lib/kaori/shows) holds
//   ID.kaori            packs; ID is the checksum of the pack's content, 64 hexadecimal digits
//   choice.0, choice.1  the choice in two generations: the older one still stands where the newer is torn
//   incoming            a pack that is being copied; of no meaning after a power cut
//   root.copy           a copy of the root's show, for the day on which the root's disk is spoilt
// One program writes the folder, kaori-shows; kaori-boot and kaori-stage read the choice.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::store {

// The show that lies in the root, which is always there.
inline constexpr std::string_view kRootShow = "root";
// Its copy in the folder of shows. Nobody chooses it.
inline constexpr std::string_view kCopiedShow = "copy";
inline constexpr const char* kCopyName = "root.copy";
// The same while it is made, and a show while it comes from a stick. No reader of the folder takes either for a show.
inline constexpr const char* kUnfinishedCopyName = "root.copying";
inline constexpr const char* kIncomingName = "incoming";
inline constexpr std::array<const char*, 2> kChoiceFiles{"choice.0", "choice.1"};

// What is played, and what was played before it: each the id of a pack, or kRootShow.
struct Choice {
  std::uint64_t generation = 0;  // Counts the choices that were made; 0: none was.
  std::string current{kRootShow};
  std::string previous{kRootShow};
  friend bool operator==(const Choice&, const Choice&) = default;
};

// Whether it is 64 hexadecimal digits in lower case: nothing else ever becomes part of a path.
bool IsId(std::string_view text);

// The name of a pack's file in the folder of shows. `id` is an id.
std::string PackName(std::string_view id);

// The text of a choice, with a checksum at its end, and back; nothing for a text that is torn or foreign.
// Pure.
std::string Format(const Choice& choice);
std::optional<Choice> ParseChoice(std::string_view text);

// The one of the higher generation of the two files' texts; nothing where neither is sound. Pure.
std::optional<Choice> NewerSound(std::string_view first, std::string_view second);

// The same; the root's show where neither is sound. Pure.
Choice Newer(std::string_view first, std::string_view second);

// Whether the folder of shows has a sound choice: it does from before its first pack on, and where it has
// packs and none, the disk has lost it. Blocks for the disk.
bool HasChoice(const std::filesystem::path& shows);

// The generation that the choice after `newest` gets, where the stage was told of `told`: above both, since
// the disk may have lost the choice of which it was told, and in the other one of the two files.
std::uint64_t NextGeneration(const Choice& newest, std::uint64_t told);

// The generation of the choice of which kaori-shows has told the stage, from a file in memory
// (/run/kaori-shows/chosen); 0: of none. Blocks for that file.
std::uint64_t ReadTold(const std::filesystem::path& file);

// Reads the choice of a folder of shows; the root's show where there is none. Blocks for the disk.
Choice ReadChoice(const std::filesystem::path& shows);

// What is to be tried, in this order: current, previous, root; each once.
std::vector<std::string> InOrder(const Choice& choice);

// The pack of a show: in `shows`, or `root_pack`. `id` is as in Choice, or kCopiedShow.
std::filesystem::path PackOf(std::string_view id, const std::filesystem::path& shows,
                             const std::filesystem::path& root_pack);

}  // namespace kaori::store
