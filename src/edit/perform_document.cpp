// Commands on the document's own members: name, start speed, datum.
#include <cmath>

#include "edit/change.h"

namespace coaster::edit {
namespace {

using base::Status;

constexpr std::size_t kMaxNameBytes = 200;

// Length in bytes of the well-formed UTF-8 sequence that `text` starts with (RFC 3629), 0 when it is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xc2 && lead < 0xe0   ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0u) != 0x80) return 0;
  const unsigned second = byte(1);
  // Overlong forms, surrogates and what lies beyond U+10FFFF.
  if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) || (lead == 0xf0 && second < 0x90) ||
      (lead == 0xf4 && second > 0x8f))
    return 0;
  return length;
}

bool printable_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0 || static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7f) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

Status perform(Session& session, Change&, const SetName& command) {
  if (command.to.size() > kMaxNameBytes)
    return refused("the name is over the limit of " + std::to_string(kMaxNameBytes) + " bytes");
  if (!printable_utf8(command.to)) return refused("expected a name in UTF-8 without control characters");
  session.document.name = command.to;
  return {};
}

Status perform(Session& session, Change& change, const SetStartSpeed& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite speed");
  session.document.start_speed =
      change.clamp("start speed", command.to, -world::kMaxSpeed, world::kMaxSpeed, "m/s");
  return {};
}

Status perform(Session& session, Change& change, const SetDatum& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite height");
  session.document.datum =
      change.clamp("datum", command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m");
  return {};
}

}  // namespace coaster::edit
