#include "appliance/programs/shows/messages.h"

namespace kaori::shows {
namespace {

struct Row {
  std::string_view english, japanese;
};

// In the order of Message. What went wrong first, then what the person does next.
constexpr std::array<Row, kMessageCount> kTable{{
    {"plug a stick in", "スティックを差してください"},
    {"there is no show on the stick; shows are files that end in .kaori",
     "スティックにショーがありません。ショーは .kaori で終わるファイルです"},
    {"Page Up opens the list of shows", "ショーの一覧はPage Upキーで開きます"},
    {"take a show by its number, or the marked one by GO; Page Up shuts the list",
     "番号で選ぶか、印の付いたショーをGOで入れてください。Page Upで一覧を閉じます"},
    {"it is being copied; leave the stick where it is", "コピーしています。スティックを抜かないでください"},
    {"it is being checked and tried; the stick can go", "確認しています。スティックは抜いて構いません"},
    {"it is on the box; the face changes to it in a moment", "入りました。まもなくこのショーになります"},
    {"it is on the box and plays now", "このショーを再生しています"},
    {"it is on the box already and is the chosen show", "すでに入っていて、選ばれています"},
    {"this box would play all shows of this key; compare its digits with its owner's",
     "この鍵のショーがすべて再生できるようになります。持ち主の英数字と照合してください"},
    {"this key is on the box now: shows that it signed will play",
     "鍵が入りました。この鍵で署名したショーを再生できます"},
    {"the support file is being written; leave the stick where it is",
     "サポートファイルを書いています。スティックを抜かないでください"},
    {"it is on the stick, for a technician; the stick can go",
     "スティックに書きました。技術者に渡してください。スティックは抜いて構いません"},
    {"the backup is being written; leave the stick where it is",
     "バックアップを書いています。スティックを抜かないでください"},
    {"the backup is on the stick; the stick can go",
     "バックアップを書きました。スティックは抜いて構いません"},
    {"the backup is made; save it from the desk's page",
     "バックアップができました。デスクのページから保存してください"},
    {"the backup is being read; leave the stick where it is",
     "バックアップを読んでいます。スティックを抜かないでください"},
    {"the lines below would change on the box; nothing has changed yet",
     "下の行が箱で変わります。まだ何も変わっていません"},
    {"the box has all of it already", "すべてこの箱にあります"},
    {"switch the box off and on: it is restored then; what was there is kept",
     "電源を切って入れ直すと復元します。今の内容は残ります"},
    {"it is restored; what was there is kept", "復元しました。前の内容は残っています"},
    {"switch the box off and on: what was there before comes back then",
     "電源を切って入れ直すと、前の内容に戻ります"},
    {"the box stays as it is", "箱は元のままです"},
    {"choose a setting by its number, or the marked one by GO",
     "番号で設定を選ぶか、印の付いた設定をGOで選んでください"},
    {"choose what it shall be; nothing has changed yet", "値を選んでください。まだ何も変わっていません"},
    {"switch the box off and on: the settings count then; those before are kept",
     "電源を切って入れ直すと新しい設定になります。前の設定は残ります"},
    {"this is no show; make it with ./box show push", "ショーのファイルではありません。作り直してください"},
    {"it is damaged; copy it to the stick again", "壊れています。もう一度スティックにコピーしてください"},
    {"its end is missing; copy it to the stick again",
     "途中で切れています。もう一度スティックにコピーしてください"},
    {"it is not signed; sign it with the company's key", "署名がありません。劇団の鍵で署名してください"},
    {"this box does not trust its signer; bring the key of whoever signed it",
     "署名した人の鍵がこの箱にありません。鍵を入れてください"},
    {"this box trusts no key yet; bring the company's public key",
     "この箱には鍵がまだありません。劇団の公開鍵を入れてください"},
    {"it is too large for a box", "大きすぎて、この箱には入りません"},
    {"it was made by newer tools; update the box, or pack it with older ones",
     "新しい道具で作られています。箱を更新するか、古い道具で作り直してください"},
    {"it was made by older tools; pack it again", "古い道具で作られています。作り直してください"},
    {"there is no room on the box", "箱に空きがありません"},
    {"the stick was pulled out or cannot be read; take it again",
     "スティックが抜けたか、読めません。もう一度入れてください"},
    {"the stick cannot be read: it has to be FAT32 or exFAT",
     "スティックを読めません。FAT32かexFATにしてください"},
    {"the box's own disk cannot be written; show this to whoever looks after the box",
     "箱のディスクに書けません。担当者に知らせてください"},
    {"it does not play on this box; what played before goes on",
     "この箱では再生できません。前のショーを続けます"},
    {"the service key was turned back before it was on the box; take it again",
     "入る前にサービスキーが戻されました。もう一度入れてください"},
    {"there is no room on the stick; take something off it, or another stick",
     "スティックに空きがありません。何か消すか、別のスティックにしてください"},
    {"the stick cannot be written; take another one", "スティックに書けません。別のスティックにしてください"},
    {"the stick was pulled out before it was written; put it in again",
     "書き終わる前にスティックが抜けました。もう一度差してください"},
    {"this is no backup of a box; copy it to the stick again",
     "箱のバックアップではありません。もう一度スティックにコピーしてください"},
    {"it was made by a newer box; update this one first",
     "新しい箱で作られています。先にこの箱を更新してください"},
    {"it has a file that belongs to no box; make it again on the box",
     "箱のものではないファイルがあります。箱で作り直してください"},
    {"something was changed on the box meanwhile; take it again",
     "途中で箱の内容が変わりました。もう一度選んでください"},
    {"these settings have a mistake; mend it and bring them again",
     "設定に間違いがあります。直して、もう一度入れてください"},
}};

}  // namespace

std::string_view Words(Message message, Language language) {
  const Row& row = kTable[static_cast<std::size_t>(message)];
  return language == Language::kEnglish ? row.english : row.japanese;
}

bool IsRefusal(Message message) {
  return message >= Message::kNotAShow || message == Message::kNoShow;
}

Message DiskMessageOf(const Error& error) {
  return error.cause == std::errc::no_space_on_device ? Message::kFull : Message::kDiskFault;
}

std::string Say(Message message, Language language, std::string_view name, std::string_view detail) {
  std::string text(name);
  if (!text.empty()) text += ": ";
  text += Words(message, language);
  if (!detail.empty()) text += " (" + std::string(detail) + ")";
  return text;
}

}  // namespace kaori::shows
