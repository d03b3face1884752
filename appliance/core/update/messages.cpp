#include "appliance/core/update/messages.h"

#include <array>

namespace kaori::update {
namespace {

struct Row {
  std::string_view english, japanese;
};

// In the order of Message. What is so first, then what the person does next.
constexpr std::array<Row, kMessageCount> kTable{{
    {"this update fits this box", "この箱に入るアップデートです"},
    {"it is being read and checked; leave the stick where it is",
     "読んで確認しています。スティックを抜かないでください"},
    {"it is being written beside what plays; leave the stick where it is",
     "書き込んでいます。スティックを抜かないでください"},
    {"it is on the box and waits; restart the box after the show, by this list",
     "入りました。公演の後、この一覧から再起動してください"},
    {"the box restarts to try it", "試すために再起動します"},
    {"it is being tried; leave the box alone for a minute", "試しています。一分間そのままにしてください"},
    {"it started with its face and is the box's system from now on", "正常に始まりました。これを使います"},
    {"this is no update; updates are files that end in .kaoriupdate",
     "アップデートではありません。.kaoriupdateで終わるファイルです"},
    {"it was made for newer boxes; take an update between the two first",
     "新しすぎます。間のアップデートを先に入れてください"},
    {"its end is missing; copy it to the stick again",
     "途中で切れています。もう一度スティックにコピーしてください"},
    {"it is damaged; copy it to the stick again", "壊れています。もう一度スティックにコピーしてください"},
    {"this box does not trust its signer; take an update from whoever made the box",
     "署名した人の鍵がこの箱にありません。製造元のものを使ってください"},
    {"it is for another kind of box", "別の種類の箱のものです"},
    {"it is older than what runs", "今のものより古いアップデートです"},
    {"it is older than this box may ever go back to", "古すぎて、この箱には戻せません"},
    {"it is too large for this box's disk", "大きすぎて、この箱のディスクに入りません"},
    {"the stick was pulled out or cannot be read; take it again",
     "スティックが抜けたか、読めません。もう一度入れてください"},
    {"the box's own disk cannot be written; show this to whoever looks after the box",
     "箱のディスクに書けません。担当者に知らせてください"},
    {"the box has no room left for a note of it; remove a show or a backup, and take it again",
     "記録する空きがありません。公演か控えを消して、もう一度入れてください"},
    {"the box's disk is of an earlier layout; it has to be written anew once",
     "ディスクの形式が古いです。一度ディスクを書き直してください"},
    {"the running system is still being tried; wait a minute",
     "今のシステムを試しています。一分お待ちください"},
    {"this PC forgets which system it is to try; the disk has to be written in another computer",
     "このPCは次に試すシステムを覚えられません。別の機械でディスクを書いてください"},
    {"no update waits on this box", "待っているアップデートはありません"},
    {"it was tried three times and gave way each time; take another update",
     "三回試して戻りました。別のアップデートを使ってください"},
    {"it was tried and gave way; the system before plays",
     "試しましたが戻りました。前のシステムで動いています"},
}};

}  // namespace

std::string_view Words(Message message, Language language) {
  const Row& row = kTable[static_cast<std::size_t>(message)];
  return language == Language::kEnglish ? row.english : row.japanese;
}

bool IsRefusal(Message message) {
  return message >= Message::kNotAnUpdate;
}

std::string Say(Message message, Language language, std::uint32_t version, std::string_view detail) {
  std::string text;
  if (version > 0)
    text = language == Language::kEnglish ? "version " + std::to_string(version) + ": "
                                          : "バージョン" + std::to_string(version) + ": ";
  text += Words(message, language);
  if (!detail.empty()) text += " (" + std::string(detail) + ")";
  return text;
}

}  // namespace kaori::update
