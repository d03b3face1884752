// A fixture: kaori-shows over a folder that stands for a mounted stick.
#pragma once

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/press_log.h"
#include "appliance/core/store/play_log.h"
#include "appliance/programs/shows/install_service.h"
#include "drivers/base/read_file.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::shows {

class ServiceTest : public tests::PackTest {
 protected:
  // What of the box itself is offered: the tests of all else speak of a list without it.
  enum class Offers { kShows, kCopies, kSettings, kAll };
  explicit ServiceTest(Offers offers = Offers::kShows) : offers_(offers) {
    for (const char* each : {"stick", "shows", "report", "root-keys"})
      std::filesystem::create_directories(folder_ / each);
    EXPECT_TRUE(SaveKey(company_, folder_ / "root-keys" / "company"));
  }
  void PutOnStick(const std::string& name, const show::SecretKey* signer) {
    show::Show show = tests::SmallShow();
    show.name = name;
    EXPECT_TRUE(show::SavePack(show, folder_ / "stick" / (name + ".kaori"), signer));
  }
  void Strike(std::uint8_t usage) {
    board::NotePress(pressed_, usage, now_);
    keys_.Write(pressed_, now_, board::SourceState::kLive);
  }
  // As the stage does when it begins a show.
  void NoteThatPlays(std::uint64_t generation, const std::string& show) {
    store::PlayLog log;
    log.generation = generation;
    log.playing = show;
    std::ofstream(folder_ / "plays") << store::Format(log);
  }
  void Present(std::uint32_t frames) { stage_.Write({.frames = frames}, now_, board::SourceState::kLive); }
  void NoteThatTold(std::uint64_t generation) {
    std::ofstream(folder_ / "report" / "chosen") << generation << "\n";
  }
  // Whether the show hears what is pressed.
  bool IsOpen() const { return board_.Read<board::ShowsMenu>().value.open != 0; }
  std::string Play(Duration time) {
    for (const Time end = now_ + time; now_ < end; now_ += InstallService::kPeriod) service_.Step(now_);
    return ReadFile(folder_ / "report" / "lines").value_or("");
  }

  void Put(const std::string& file, const std::string& text) const { std::ofstream(folder_ / file) << text; }
  std::string Text(const std::string& file) const { return ReadFile(folder_ / file).value_or("nothing"); }
  // Chooses the line of the list with these words, by its number, and gives what is said then.
  std::string Choose(const std::string& words) {
    std::string said = Play(std::chrono::seconds(1));
    const auto at = said.find(words);
    EXPECT_NE(at, std::string::npos) << "no \"" << words << "\" in " << said;
    if (at == std::string::npos) return said;
    const auto number = std::stoi(said.substr(said.find_first_of("123456789", said.rfind('\n', at) + 1)));
    Strike(static_cast<std::uint8_t>(board::key::k1 + (number - 1)));
    return Play(std::chrono::seconds(2));
  }

  const show::SecretKey company_ = show::MakeKey().value(), theatre_ = show::MakeKey().value();
  const Offers offers_;
  bool plugged_ = false, unreadable_ = false, writable_ = false, may_work_ = true;
  int opened_ = 0;
  Result<void> closed_{};  // Of a stick that is to be written.
  Result<void> trial_{};
  Result<std::string> support_ = std::string("kaori-1a2b3c4d-20261123-221005.txt");
  board::Board board_ = board::Board::Create((folder_ / "board").string()).value();
  board::Writer<board::Keys> keys_ = board_.AcquireWriter<board::Keys>().value();
  board::Writer<board::StageStatus> stage_ = board_.AcquireWriter<board::StageStatus>().value();
  board::Keys pressed_;
  Time now_ = Time{} + std::chrono::seconds(1000);
  std::unique_ptr<Folder> shows_ = OpenFolder(folder_ / "shows");
  BoxCopies copies_{{.data = folder_,
                     .name = [] { return std::string("left-1a2b3c4d"); },
                     .wall = [] { return std::time_t{1'795'072'000}; },
                     .set_writable =
                         [this](bool writable) {
                           writable_ = writable;
                           opened_ += writable ? 1 : 0;
                           return writable ? closed_ : Result<void>{};
                         }},
                    [this](const std::filesystem::path&) { return trial_; }};
  // Where the desk calls, as this test may.
  DeskLink desk_ = DeskLink::Open((folder_ / "desk").string(), ::geteuid()).value();
  BoxSettings settings_{{.data = folder_, .zones = folder_ / "zones", .screens = folder_ / "screens"}};
  InstallService service_{
      {folder_ / "root-keys", folder_ / "settings/keys", folder_ / "report", folder_ / "plays",
       (folder_ / "update").string(), folder_ / "pending", folder_ / "before"},
      *shows_,
      board_,
      [this]() -> Result<std::optional<std::filesystem::path>> {
        if (unreadable_) return FailInput("mount the stick /dev/sdb1");
        if (!plugged_) return std::optional<std::filesystem::path>();
        return std::optional(folder_ / "stick");
      },
      [this](const std::filesystem::path&) { return trial_; },
      {.support = [this](const std::filesystem::path&) { return support_; },
       .copies = offers_ == Offers::kCopies || offers_ == Offers::kAll ? &copies_ : nullptr,
       .settings = offers_ == Offers::kSettings || offers_ == Offers::kAll ? &settings_ : nullptr,
       .desk = offers_ == Offers::kShows ? nullptr : &desk_,
       .may_work = [this] { return may_work_; }}};
};

}  // namespace kaori::shows
