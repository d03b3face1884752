// How the editor opens: with what an earlier session left.
#include "appliance/programs/editor/expression_editor.h"

#include <cstdlib>
#include <system_error>
#include <utility>

#include "drivers/base/log.h"

namespace kaori::editor {
namespace {

// In the folder of the own expressions: both belong to the box and survive an update of its system.
constexpr const char* kJournalName = "needles.journal";

// In the order of their indices.
std::vector<std::string> NamesOf(const face::Cast& cast) {
  std::vector<std::string> names;
  for (const face::Expression& expression : cast.expressions) names.push_back(expression.name);
  return names;
}

// As the cast holds expressions; of what no control point can say (a residual) the box's own have nothing.
face::Expression ExpressionOf(const Work& work) {
  return {.name = work.name, .displacement = work.pulls_m, .lids = work.lids};
}

// A blank where a slot is empty. kSlots own expressions, then the draft: the painter allocates for all of
// them when it is opened, and renewing one later changes numbers only.
void Append(const Slots& slots, const Work& work, face::Cast& cast) {
  const Work blank{.pulls_m = std::vector<glm::vec3>(cast.net.points.size())};
  for (const auto& own : slots) cast.expressions.push_back(ExpressionOf(own ? *own : blank));
  cast.expressions.push_back(ExpressionOf(work));
}

// Undo works over a crash, since the session is led through the same changes again.
void Replay(const std::vector<Record>& records, Session& session) {
  for (const Record& record : records) session.Replay(record.change, record.work);
  if (!session.unsaved()) return;
  const Work& work = session.work();
  Log("unsaved needle work is taken up again: {}, {} steps; Tab goes on with it",
      work.name.empty() ? "without a name" : work.name, session.undoable());
}

// An empty folder (UsualFolder has found none) is an error here, which the caller turns into work in memory.
Result<void> MakeFolder(const std::filesystem::path& folder) {
  if (folder.empty()) return Fail(std::errc::no_such_file_or_directory, "find a folder for own expressions");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder.string());
  return {};
}

// Without a journal (no folder, a full disk, another editor on the same one) the editor works in memory and
// says so in its caption.
std::optional<Journal> ReadJournal(const std::filesystem::path& folder, Session& session,
                                   std::string& trouble) {
  auto opened = MakeFolder(folder).and_then(
      [&] { return Journal::Open(folder / kJournalName, Fingerprint(session.points())); });
  if (!opened) {
    trouble = opened.error().message();
    LogWarning("the needles keep no journal: {}", trouble);
    return std::nullopt;
  }
  if (opened->put_aside) Log("a needles' journal of another cast is kept aside in {}", folder.string());
  if (opened->torn_bytes > 0) LogWarning("the needles' journal ended in a torn record, which is left out");
  Replay(opened->records, session);
  return std::move(opened->journal);
}

}  // namespace

struct ExpressionEditor::Kept {
  std::filesystem::path folder;
  Session session;
  Slots slots{};
  std::optional<Journal> journal{};
  std::string trouble{};
};

// The names of the show are noted before the own expressions are appended: an own one may not have any of
// them. An own expression may build on the show's, so that the store is read before the cast is changed.
std::unique_ptr<ExpressionEditor> ExpressionEditor::Open(const std::filesystem::path& folder,
                                                         show::Show& show) {
  Kept kept{folder, Session(PointsOf(show.cast.net))};
  kept.journal = ReadJournal(folder, kept.session, kept.trouble);
  if (!folder.empty()) {
    Stored stored = ReadStore(folder, kept.session.points(), show.cast);
    for (const std::string& complaint : stored.complaints) LogWarning("{}", complaint);
    kept.slots = std::move(stored.slots);
  }
  const std::vector<std::string> names = NamesOf(show.cast);
  Append(kept.slots, kept.session.work(), show.cast);
  return std::unique_ptr<ExpressionEditor>(new ExpressionEditor(std::move(kept), show.cast, names));
}

ExpressionEditor::ExpressionEditor(Kept kept, const face::Cast& cast, std::vector<std::string> show_names)
    : first_(show_names.size()),
      session_(std::move(kept.session)),
      own_(std::move(kept.slots), std::move(show_names)),
      picker_(cast),
      trouble_(std::move(kept.trouble)),
      writer_(std::move(kept.journal), std::move(kept.folder), session_.points()) {}

ExpressionEditor::~ExpressionEditor() = default;

// On the box the folder is there and belongs to the stage's user; on a developer's machine it is where such
// data belong (XDG base directories).
std::filesystem::path UsualFolder() {
  std::filesystem::path box = "/var/lib/kaori/own";
  std::error_code none;
  if (std::filesystem::is_directory(box, none)) return box;
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0')
    return std::filesystem::path(state) / "kaori" / "own";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::filesystem::path(home) / ".local" / "state" / "kaori" / "own";
  return {};
}

}  // namespace kaori::editor
