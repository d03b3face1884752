// Which show this stage plays: the chosen one, unless it cannot be read or has ended the stage too often;
// then the one before it, and at last the root's, or its copy.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "appliance/core/show/pack.h"
#include "appliance/core/show/show.h"
#include "appliance/core/store/play_log.h"
#include "appliance/programs/stage/taught_writer.h"
#include "drivers/base/clock.h"
#include "drivers/base/read_file.h"
#include "drivers/base/result.h"

namespace kaori::stage {

// Where shows lie. Without `shows` there is one, `root_pack`, and nothing is noted.
struct ShowPlaces {
  std::filesystem::path root_pack;
  std::filesystem::path shows;  // The folder of the data partition; appliance/core/store/choice.h.
  std::filesystem::path keys;   // Of the data partition: public keys that were brought to the box.
  std::filesystem::path
      play_log;  // In memory, and beside it what is said of the root's show: play_log.h of the store.
  std::filesystem::path
      chosen{};  // In memory: the number of the choice that counts; empty: none is followed.
  std::filesystem::path key_files{};  // In memory: where pictures of keys are laid out; empty: nowhere.
  show::LoadOptions of_root{};        // How the root's own pack is opened.
  // Whether a disk gives all of a file, before it is mapped; a test has another one.
  std::function<Result<void>(const std::filesystem::path&)> read_through = ReadThrough;
  // Called before all of a file is read, which can take long: of each but the root's, and of that where it is in doubt.
  // Null: nobody is told.
  std::function<void(const std::filesystem::path&)> before_reading{};
};

// A show that was read, and where.
struct ChosenShow {
  show::Show show;
  std::string id;  // Of the store, or store::kRootShow.
  std::filesystem::path pack;
  std::uint64_t generation = 0;  // Of the newest choice that was known then.
  bool another = false;          // The stage before this one played another show.
};

// Reads the first show of those to try that can be read, and notes that it plays; says in the log which were
// passed over and why. The root's show, which is mapped and believed, is read from front to back first where it has ended
// the stage twice: a block that its disk has spoilt is an error then, and no end by a signal for ever. Its copy plays then,
// and the status picture says so; where there is none, a file beside the log asks for the box's other system. A pack of `shows` must be signed by a key beside the root's pack (its folder's `keys`)
// or of `keys`, and is always checked as a whole. The pictures of keys that the show brings are laid out (key_files.h).
// Blocks for the disk. Errors: those of LoadPack and
// ReadThrough for the root's show.
Result<ChosenShow> LoadChosen(const ShowPlaces& places, Time now);

// The box's own roles, for a show that has only its own yet.
OwnRoles OwnRolesOver(const show::Show& show, std::filesystem::path file);

// Lays the box's own roles.toml over the show's, where there is one. One that is wrong is named in the log
// and not used: the show's own roles play. Blocks for the disk.
void LayOverRoles(const OwnRoles& own, show::Show& show);

// The stage ends of its own will: the show is not to blame. Blocks for a file in memory.
void NoteOrderlyEnd(const ShowPlaces& places);

// Looks, beside the frames, what becomes of the show that plays. One thread.
class ShowWatch {
 public:
  // `generation` is that of the ChosenShow, `first_picture` when its first picture was drawn.
  ShowWatch(ShowPlaces places, std::uint64_t generation, Time first_picture)
      : places_(std::move(places)), generation_(generation), first_picture_(first_picture) {}

  // To be called some times a second: notes once that the show has been seen for store::kSettlesAfter. True
  // from when kaori-shows has said, in memory, so that no disk is asked while a show plays, that another one
  // is chosen: the stage is to end, to be started with that. Blocks for a file in memory.
  bool IsOver(Time now);

 private:
  ShowPlaces places_;
  std::uint64_t generation_;
  Time first_picture_;
  bool settled_ = false;
};

}  // namespace kaori::stage
