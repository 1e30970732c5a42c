// Queries of the current challenge and of the last ride's score card.
#include <algorithm>
#include <array>
#include <cmath>

#include "query/challenge.h"
#include "query/rows.h"
#include "world/aids.h"

namespace coaster::query {
namespace {

constexpr View kNoChallenge = "there is no challenge";

Answer active(const Context& c, View) { return yes_no(c.session.game.challenge.has_value()); }
Answer challenge_name(const Context& c, View) {
  return c.session.game.challenge ? text(c.session.game.challenge->file.name) : none(kNoChallenge);
}
template <class Counts>
Answer count(const Context& c, Counts counts) {
  if (!c.session.game.challenge) return none(kNoChallenge);
  const auto rules = read_rules(c.session.game.challenge->file, c.session.game.challenge->path);
  if (!rules) return rules.status();
  return number(std::count_if(rules->begin(), rules->end(), counts));
}
Answer goals(const Context& c, View) { return count(c, must_hold); }
Answer met(const Context& c, View) {
  return count(c, [&](const Rule& rule) { return must_hold(rule) && look_at(c.find, rule).holds; });
}
Answer passed(const Context& c, View) {
  return yes_no(c.session.game.challenge && c.session.game.challenge->medal > 0);
}
Answer failure(const Context& c, View) {
  return c.session.game.challenge ? text(c.session.game.challenge->last.reason) : none(kNoChallenge);
}
template <auto member>
Answer of_challenge(const Context& c, View) {
  return c.session.game.challenge ? value_of((*c.session.game.challenge).*member) : none(kNoChallenge);
}
template <auto member>
Answer of_card(const Context& c, View) {
  return c.session.game.result ? value_of((*c.session.game.result).*member) : none("no ride has ended");
}
Answer rides(const Context& c, View) { return number(c.session.game.result ? c.session.game.result->serial : 0); }
Answer challenge_deviation(const Context& c, View) {
  if (!c.session.game.challenge) return none(kNoChallenge);
  const double deviation = c.find.deviation();
  return std::isfinite(deviation) ? number(deviation) : none(kNoSegment);
}

Answer card_shows(const Context& c, View) {
  return yes_no(c.session.settings.aids->show_card && c.session.game.show_result && c.session.game.result);
}
constexpr std::array kGameRows{
    Query{"challenge.active", kNoArgument, "", "on during a challenge.", active, kSwitch},
    Query{"challenge.name", kNoArgument, "", "Name of the challenge, none without one.", challenge_name,
          or_none(kText)},
    Query{"challenge.goals", kNoArgument, "", "Number of goals and limits of the challenge.", goals, or_none()},
    Query{"challenge.met", kNoArgument, "",
          "Number of them that hold now; rules about the ride use the simulated ride.", met, or_none()},
    Query{"challenge.passed", kNoArgument, "", "on if the challenge has been passed since it was started.", passed,
          kSwitch},
    Query{"challenge.medal", kNoArgument, "", "Best medal since it was started: 0 none, 1 bronze, 2 silver, 3 gold.",
          of_challenge<&edit::ActiveChallenge::medal>, or_none()},
    Query{"challenge.judged", kNoArgument, "", "Number of judgements since it was started.",
          of_challenge<&edit::ActiveChallenge::judged>, or_none()},
    Query{"challenge.failure", kNoArgument, "", "Why the last judgement failed; empty if it passed or there was none.",
          failure, or_none(kText)},
    Query{"challenge.hints", kNoArgument, "", "Number of hints shown.", of_challenge<&edit::ActiveChallenge::hints>,
          or_none()},
    Query{
        "challenge.deviation", kNoArgument, "m",
        "Largest distance between the track and the challenge's start track, independent of their knots; none without "
        "either.",
        challenge_deviation, or_none()},
    Query{"card.shows", kNoArgument, "", "on while a score card is shown.", card_shows, kSwitch},
    Query{"card.end", kNoArgument, "", "How the last ride ended: lap, open end, time, failed; none before the first.",
          of_card<&edit::RideResult::end>, or_none(kOneOf<edit::RideEnd>)},
    Query{"card.reason", kNoArgument, "", "Why it ended, if not with a lap.", of_card<&edit::RideResult::reason>,
          or_none(kText)},
    Query{"card.seconds", kNoArgument, "s", "Duration of the last ride.", of_card<&edit::RideResult::seconds>,
          or_none()},
    Query{"card.rides", kNoArgument, "", "Number of rides that ended since the track was opened.", rides},
};

}  // namespace

std::span<const Query> game_rows() { return kGameRows; }

}  // namespace coaster::query
