// The work of kaori-shows while the service key is on: looks for a stick, offers what lies on it and the
// shows that are on the box, installs what is taken, and says at each moment how that stands.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/core/update/caller.h"
#include "appliance/core/update/pending.h"
#include "appliance/programs/shows/box_copies.h"
#include "appliance/programs/shows/box_settings.h"
#include "appliance/programs/shows/desk_link.h"
#include "appliance/programs/shows/installation.h"
#include "appliance/programs/shows/menu.h"
#include "drivers/base/clock.h"

namespace kaori::shows {

// A report that cannot be written costs the lines on the screen, and not the installation.
void WriteSaid(const std::filesystem::path& file, const std::string& text);

struct ServicePlaces {
  // Public keys of the house, in the root.
  std::filesystem::path root_keys;
  // Public keys that were brought to the box.
  std::filesystem::path keys;
  // A folder in memory: `lines` for the screen, `chosen` for the stage.
  std::filesystem::path report;
  std::filesystem::path
      // What the stage says of the show that plays: appliance/core/store/play_log.h.
      plays{};
  // Where kaori-update listens, and the notes of an update that waits and of the system before.
  std::string update_socket = update::kSocket;
  std::filesystem::path pending = update::kPendingFile;
  std::filesystem::path before = update::kBeforeFile;
};

// Gives the folder in which a stick is mounted; nothing while none is; an error where one is plugged in that
// cannot be mounted. Called every half second.
using LookForStick = std::function<Result<std::optional<std::filesystem::path>>()>;

// Writes a support file onto the stick, and gives its name. Blocks for seconds. Errors: those of
// support_file.h.
using MakeSupportFile = std::function<Result<std::string>(const std::filesystem::path& stick)>;

// What of the box itself can be taken to a stick and brought from one; where one is null it is not offered. They outlive the
// service.
struct OfBox {
  MakeSupportFile support{};
  BoxCopies* copies = nullptr;
  BoxSettings* settings = nullptr;
  // Where visitors of the desk see the list and take lines of it.
  DeskLink* desk = nullptr;
  // Whether a show or a backup may be copied on now, beside the face; null: always.
  std::function<bool()> may_work{};
};

// One thread; folder and board must outlive it. While another program has the board's section `shows_menu`
// the show hears what is pressed in the list.
class InstallService {
 public:
  // Without `support` no such file is offered.
  InstallService(ServicePlaces places, Folder& folder, const board::Board& board, LookForStick look,
                 Trial trial, OfBox of_box = {});
  ~InstallService();
  InstallService(const InstallService&) = delete;
  InstallService& operator=(const InstallService&) = delete;

  // To be called every kPeriod: a step copies 1 MiB at most, so that the disk has time for others.
  void Step(Time now);

  // Says on the board whether the list is open. Step does; to be called besides, some times a second, while
  // Step is busy with a trial.
  void KeepAlive(Time now);

  static constexpr Duration kPeriod = std::chrono::milliseconds(50);

 private:
  // A stick came or went. Nothing of it is shown while a show is installed; the next look after that makes up
  // for it.
  void Look(Time now);
  // Whether somebody checks lines, teaches or calibrates lips: presses are for that.
  bool IsBusyElsewhere(Time now) const;
  // Tells the stage of the choice that was just made, and waits for it to play.
  void TellStage();
  // Says how it went on with what was installed last: the stage plays it, or gave it up.
  void FollowChosen();
  // Lists what lies at the top of the stick, opens the list, and says so; blocks for the stick.
  void OfferAll(const std::filesystem::path& stick, Time now);
  // No stick is in: the shows that are on the box are left, for whoever opens the list.
  void OfferBefore();
  // As it is now, after a show came or another one was chosen.
  void ListAnew();
  // Offers it, with the ways back below it, and gives how many of the stick are listed. Errors: those of
  // OffersOf.
  Result<std::size_t> List(const std::filesystem::path& stick);
  // What the menu gave: a show is begun; of a key it is asked whether it is trusted.
  void Accept(const Choosable& taken);
  void AskForKey(const Choosable& taken);
  void AnswerForKey(const Choosable& taken);
  // Keeps a key that is trusted from now on. Errors: those of WriteWholeFile.
  Result<void> KeepKey(const show::PublicKey& key) const;
  // Chooses a show that is on the box; the stage is told.
  void GoBack(const Choosable& taken);
  void Install(const Choosable& taken);
  // The ways back to shows, the restart that tries an update, and what backups, restores and settings offer.
  std::vector<Choosable> WaysBackOnBox(bool has_stick) const;
  // Something of BoxCopies was taken, or what it asks is answered.
  void AcceptCopy(const Choosable& taken);
  void StepCopies(Time now);
  // Something of BoxSettings was taken, or what it asks is answered.
  bool IsOfSettings(const Choosable& taken) const;
  void AcceptSettings(const Choosable& taken);
  // How that stands: the list asks, or is the one of shows again. `is_left`: nobody is to be told of which settings.
  void TellOfSettings(const Progress& progress, bool is_left);
  // Something is on its way; nothing else is taken meanwhile.
  bool IsBusy() const;
  bool MayWork() const { return !of_box_.may_work || of_box_.may_work(); }
  // The desk's part: what a visitor asks for, and the state for its page.
  void HearDesk();
  void CopyForDesk(Request request);
  void TellDesk(Time now);
  std::string StateForDesk() const;
  // Nobody can answer any more: another stick is in, or none.
  void DropQuestion();
  // At the step after the one that said that it begins.
  void WriteSupport();
  // The next piece; tells what has changed, and the stage where the show is on the box.
  void StepInstallation();
  // Asks kaori-update for it: an update is brought in, or tried by a restart.
  void CallUpdate(const Choosable& taken);
  // What it answers.
  void FollowUpdate();
  // Says it on the screen, and in the log where it is another message than before.
  void Tell(Message message, const std::string& name = {}, const std::string& reason = {});
  // The same of the stick that is in, with which it goes.
  void TellOfStick(Message message, const std::string& reason = {});
  // The same of an update; the log hears each message once.
  void TellOfUpdate(const update::Answer& answer);
  // What is said now, in one line; nothing has to be said yet where said_ is empty. And whether it is a refusal.
  std::string Sentence(Language language) const;
  bool SaidIsRefusal() const;
  // Writes what is said to the screen, with the list as it is.
  void Show();
  // Shows the list where it was opened, and takes it away where it was shut.
  void FollowMenu(Time now);
  // Of the choice that the stage was told of last, since the box was switched on; 0: of none.
  std::uint64_t Told() const;
  show::PublicKeys Keys() const;
  // The show that plays; empty where the stage has said nothing.
  std::string Plays() const;

  ServicePlaces places_;
  Folder& folder_;
  const board::Board& board_;
  LookForStick look_;
  Trial trial_;
  OfBox of_box_;
  std::optional<std::filesystem::path> stick_;
  Time look_next_{};
  Menu menu_;
  std::optional<Installation> installation_;
  // Of what is being installed.
  std::string name_;
  bool writes_support_ = false;
  // While kaori-update is at it.
  std::optional<update::Caller> update_;
  // What was chosen and has not been seen to play yet, and the frames of the board when the stage had begun it.
  std::optional<store::Choice> awaited_;
  std::optional<std::uint32_t> frames_at_begin_;
  // What is said.
  struct Said {
    Message message = Message::kPlugIn;
    std::string name{}, detail{};
    bool of_stick = false;
    // In place of the message.
    std::optional<update::Answer> of_update{};
  };
  std::optional<Said> said_;
  // The text on the screen.
  std::string shown_;
  // It shows the list.
  bool is_open_ = false;
  bool has_looked_ = false;
  std::optional<board::Writer<board::ShowsMenu>> on_board_;
  // The desk is told no sooner.
  Time tell_next_{};
};

}  // namespace kaori::shows
