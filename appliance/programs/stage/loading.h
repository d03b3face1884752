// Everything of a stage's start that needs no graphics card: where shows lie, and the one that is played, read and prepared.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "appliance/core/showlog/format.h"
#include "appliance/programs/editor/expression_editor.h"
#include "appliance/programs/stage/chosen_show.h"
#include "appliance/programs/stage/stage_options.h"
#include "appliance/programs/stage/studio.h"
#include "appliance/programs/stage/taught_writer.h"
#include "drivers/base/result.h"

namespace kaori::stage {

// What the loading thread hands over: the editor has appended its expressions to the show before it is
// prepared.
struct Loaded {
  std::unique_ptr<editor::ExpressionEditor> editor;
  OwnRoles own_roles;
  std::unique_ptr<PreparedShow> show;
  showlog::LogHead log_head;  // Made where a log is wanted: it takes a checksum of the whole program.
  std::filesystem::path pack;
  std::uint64_t generation = 0;
  bool another = false;
};

// Keys that were brought to the box lie beside its shows, and what became of each show beside the board, in
// memory. The service manager is told before all of a show is read. Errors: those of show::LoadOptionsOf.
Result<ShowPlaces> PlacesOf(const StageOptions& options);

// Where the box keeps what was made on it.
std::filesystem::path OwnFolder(const StageOptions& options);

// Runs on the loading thread: file, checks, the editor's journal and all that can be worked out without a
// graphics card. Blocks for the disk. Errors: those of LoadChosen.
Result<Loaded> LoadShow(const StageOptions& options, const ShowPlaces& places);

}  // namespace kaori::stage
