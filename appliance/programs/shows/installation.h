// Installs a show: copies a pack from a stick, checks it in every way there is, and only then makes it the
// one that plays. At each moment, whatever fails, the show that played before is whole and chosen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "appliance/core/show/pack_container.h"
#include "appliance/programs/shows/choice_files.h"
#include "appliance/programs/shows/folder.h"
#include "appliance/programs/shows/messages.h"

namespace kaori::shows {

// A pack on a stick. Nothing of it is believed, and it may go at any moment.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t bytes() const = 0;
  // Fills `into` as far as the file goes, and says how far. Blocks for the stick. Errors: those of read(2).
  virtual Result<std::size_t> Read(std::span<std::uint8_t> into) = 0;
};

// Errors: those of open(2); invalid_argument for what is no regular file.
Result<std::unique_ptr<Source>> OpenSource(const std::filesystem::path& file);

// What an error of reading a pack means to a person.
Message MessageOf(const Error& error);

// How an installation stands. `detail` is the reason in the words of the log, English.
struct Progress {
  Message message = Message::kCopying;
  std::string detail{};
  // Of the copy, 0..1.
  float done = 0;
};

// Judges the copy as a whole, by its path: the verifier, and a rehearsal. It was hashed already. Blocks.
using Trial = std::function<Result<void>(const std::filesystem::path& pack)>;

// What a new show is chosen beside.
struct OnBox {
  // The show that plays, where that is not the chosen one: an id or kRootShow.
  std::string plays{};
  // The generation of the choice of which the stage was told last.
  std::uint64_t told = 0;
};

// One thread; the folder and the source must outlive it. Destroyed on the way it leaves nothing behind that
// counts.
class Installation {
 public:
  // `keys` are those that the box trusts.
  Installation(Folder& folder, std::unique_ptr<Source> source, show::PublicKeys keys, Trial trial,
               OnBox on_box = {});

  // Does the next piece of the work, 1 MiB of the copy at most, and says how it stands. To be called until
  // ended().
  const Progress& Step();
  bool ended() const { return stage_ == Stage::kEnded; }
  const Progress& progress() const { return progress_; }

  // Left free for settings and what the box keeps, whatever is installed.
  static constexpr std::uint64_t kReserve_bytes = std::uint64_t{4} << 20U;
  static constexpr std::size_t kPiece_bytes = std::size_t{1} << 20U;

 private:
  enum class Stage : std::uint8_t { kHeader, kCopy, kTry, kSwitch, kEnded };

  // One for each stage. Each ends in the next one, or in Refuse.
  void ReadHeader();
  // Of the show that plays: whether it has to be copied. Blocks for its trial.
  bool NeedsCopy();
  void CopyPiece();
  void TryIt();
  void Switch();
  // Ends with a refusal, and removes what was copied.
  void Refuse(Message message, std::string detail = {});
  void RefuseFolder(const Error& error);
  // The room that it has and that is not free yet. Errors: those of the folder.
  Result<std::uint64_t> RemoveUnfinishedCopy();
  // Removes packs until there is room: the copy of the root's, those that nobody plays, in the order of their names, and last the one
  // that was played before. What plays and what is chosen stays, but a spoilt one that is copied anew.
  Result<bool> MakeRoom(std::uint64_t bytes);
  // The packs that may go, in the order in which they do.
  Result<std::vector<std::string>> Removable() const;
  // A folder that gets its first pack says before that nothing is chosen yet.
  Result<void> BeginChoices();
  // What is played where the new show gives way.
  std::string ShowBefore() const;

  Folder& folder_;
  std::unique_ptr<Source> source_;
  show::PublicKeys keys_;
  Trial trial_;
  Stage stage_ = Stage::kHeader;
  Progress progress_;
  store::Choice before_;
  std::string plays_;
  std::uint64_t told_;
  show::PackSeal seal_;
  std::string id_;
  // On the box and whole: it is chosen without a copy.
  bool is_there_ = false;
  // On the box, and found to be no whole show.
  bool spoilt_ = false;
  std::unique_ptr<Draft> draft_;
  show::Checksummer sum_;
  // Of the content, without the header.
  std::uint64_t copied_bytes_ = 0;
};

// Removes what an installation left that was cut off: a copy that is half done takes the room of a show. What
// cannot be removed stays for the next one, which replaces it.
void RemoveLeftovers(Folder& folder);

}  // namespace kaori::shows
