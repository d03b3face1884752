// The part of Desk that has to do with the box itself, whose list and settings kaori-shows keeps.
#include <fmt/format.h>

#include "appliance/programs/desk/desk.h"
#include "appliance/programs/shows/protocol/protocol.h"
#include "drivers/base/number.h"

namespace kaori::desk {
namespace {

using web::Reply;
using web::Request;

constexpr const char* kPlain = "text/plain; charset=utf-8";
// What a page that is open notices: five times a second is when kaori-shows says something new at most.
constexpr Duration kSame = std::chrono::seconds(1);

}  // namespace

// "null" says that kaori-shows is away.
void Desk::SendBox(Time now) {
  if (!boxes_.awaited()) return;
  const std::string state = box_.state().value_or("null");
  if (state == box_state_ && now - box_at_ < kSame) return;
  box_state_ = state;
  box_at_ = now;
  boxes_.Publish(fmt::format("data: {}\n\n", state));
}

// As kaori-shows has written it: a program of the box, which is believed.
Reply Desk::Box() const {
  if (!box_.state()) return {503, kPlain, "the program for shows does not answer\n"};
  return {200, "application/json", *box_.state() + "\n"};
}

// What becomes of it stands in the state. A backup that was brought goes with the request for its restore.
Reply Desk::AskBox(const Request& request) {
  const auto wanted = shows::ParseRequest(request.body);
  if (!wanted) return {400, kPlain, "there is no such request to the box\n"};
  const bool restores = wanted->kind == shows::Request::Kind::kRestore;
  const UniqueFd brought = restores ? brought_.Release() : UniqueFd();
  if (restores && !brought.valid()) return {409, kPlain, "no backup was brought\n"};
  const auto sent = box_.Send(request.body, brought.get());
  if (sent) return {204, kPlain, {}};
  return {503, kPlain, "the program for shows does not answer\n"};
}

// It can be fetched as often as somebody wants until there is another one, or kaori-shows ends.
Reply Desk::Backup() const {
  auto file = box_.OpenBackup();
  if (!file) return {404, kPlain, "there is no backup\n"};
  return {200, "application/octet-stream", {}, {}, std::move(*file), box_.backup_name()};
}

Reply Desk::AcceptPart(const Request& request) {
  const auto at = ParseNumber<std::uint64_t>(std::string_view(request.path).substr(kBroughtPath.size()));
  if (!at) return {400, kPlain, "a part begins at a byte\n"};
  const auto added = brought_.Add(*at, request.body);
  if (added) return {204, kPlain, {}};
  const bool is_other = added.error().kind == ErrorKind::kInput;
  return {is_other ? 409U : 507U, kPlain, added.error().message() + "\n"};
}

}  // namespace kaori::desk
