// Queries of the current challenge and of the last ride's score card.
#include <algorithm>
#include <array>

#include "query/challenge.h"
#include "query/rows.h"

namespace coaster::query {
namespace {

bool must_hold(const Rule& rule) {
  return rule.list != exchange::RuleList::silver && rule.list != exchange::RuleList::gold;
}

Answer active(const Context& c, View) { return yes_no(c.session.challenge.has_value()); }
Answer challenge_name(const Context& c, View) {
  return text(c.session.challenge ? c.session.challenge->file.name : "");
}
template <class Counts>
Answer count(const Context& c, Counts counts) {
  if (!c.session.challenge) return number(0);
  const auto rules = read_rules(c.session.challenge->file, c.session.challenge->path);
  if (!rules) return rules.status();
  return number(std::count_if(rules->begin(), rules->end(), counts));
}
Answer goals(const Context& c, View) { return count(c, must_hold); }
Answer met(const Context& c, View) {
  return count(c, [&](const Rule& rule) { return must_hold(rule) && look_at(c.session, rule).holds; });
}
Answer medal(const Context& c, View) { return number(c.session.challenge ? c.session.challenge->medal : 0); }
Answer passed(const Context& c, View) { return yes_no(c.session.challenge && c.session.challenge->medal > 0); }
Answer judged(const Context& c, View) { return number(c.session.challenge ? c.session.challenge->judged : 0); }
Answer failure(const Context& c, View) { return text(c.session.challenge ? c.session.challenge->last.reason : ""); }
Answer challenge_hints(const Context& c, View) { return number(c.session.challenge ? c.session.challenge->hints : 0); }
Answer challenge_deviation(const Context& c, View) {
  if (!c.session.challenge) return number(0.0);
  const edit::ActiveChallenge& challenge = *c.session.challenge;
  constexpr double kNothingThere = 1e9;  // m, if there is no track
  sim::ShapeTrace now = sim::trace_of(c.session.document);
  if (!challenge.deviation || !(challenge.deviation->of == now)) {
    const double metres = std::min(sim::shape_distance(now, challenge.shape), kNothingThere);
    challenge.deviation = edit::ActiveChallenge::Deviation{std::move(now), metres};
  }
  return number(challenge.deviation->metres);
}

Answer card(const Context& c, View) { return yes_no(c.session.settings.show_card); }
Answer card_shows(const Context& c, View) {
  return yes_no(c.session.settings.show_card && c.session.show_result && c.session.result);
}
Answer card_end(const Context& c, View) {
  if (!c.session.result) return text("none");
  switch (c.session.result->end) {
    case edit::RideEnd::lap: return text("lap");
    case edit::RideEnd::open_end: return text("open end");
    case edit::RideEnd::time: return text("time");
    case edit::RideEnd::failed: return text("failed");
  }
  return text("");
}
Answer card_reason(const Context& c, View) { return text(c.session.result ? c.session.result->reason : ""); }
Answer card_rides(const Context& c, View) { return number(c.session.result ? c.session.result->serial : 0); }
Answer card_seconds(const Context& c, View) { return number(c.session.result ? c.session.result->seconds : 0.0); }

constexpr std::array kGameRows{
    Query{"challenge.active", "", "", "on while a challenge is under way.", active},
    Query{"challenge.name", "", "", "The challenge's name, empty without one.", challenge_name},
    Query{"challenge.goals", "", "", "Goals and limits of the challenge.", goals},
    Query{"challenge.met", "", "", "How many of them hold now, by the ghost where they ask about the ride.", met},
    Query{"challenge.passed", "", "", "on once the challenge was passed since it was begun.", passed},
    Query{"challenge.medal", "", "", "The best medal since it was begun: 0 none, 1 bronze, 2 silver, 3 gold.", medal},
    Query{"challenge.judged", "", "", "How often it was judged since it was begun.", judged},
    Query{"challenge.failure", "", "",
          "Why it was not passed when it was judged last; empty when it was, or never was judged.", failure},
    Query{"challenge.hints", "", "", "Hints that show.", challenge_hints},
    Query{"challenge.deviation", "", "m",
          "How far the track and the challenge's start track are apart at most, whatever their knots; 0 without a "
          "challenge.",
          challenge_deviation},
    Query{"card", "", "", "on when a score card shows at the end of a ride.", card},
    Query{"card.shows", "", "", "on while a score card shows.", card_shows},
    Query{"card.end", "", "", "How the last ride ended: lap, open end, time, failed; none before the first.", card_end},
    Query{"card.reason", "", "", "Why it ended where it was not a lap.", card_reason},
    Query{"card.seconds", "", "s", "How long it lasted.", card_seconds},
    Query{"card.rides", "", "", "Rides that ended since the track was opened.", card_rides},
};

}  // namespace

std::span<const Query> game_rows() { return kGameRows; }

}  // namespace coaster::query
