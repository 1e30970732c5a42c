// Queries of the current challenge and of the last ride's score card.
#include <algorithm>
#include <array>

#include "query/challenge.h"
#include "query/rows.h"
#include "world/aids.h"

namespace coaster::query {
namespace {

Answer active(const Context& c, View) { return yes_no(c.session.game.challenge.has_value()); }
Answer challenge_name(const Context& c, View) {
  return text(c.session.game.challenge ? c.session.game.challenge->file.name : "");
}
template <class Counts>
Answer count(const Context& c, Counts counts) {
  if (!c.session.game.challenge) return number(0);
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
  return text(c.session.game.challenge ? c.session.game.challenge->last.reason : "");
}
// A member of an optional value of the game; its initial value if there is none.
template <auto optional, auto member>
Answer of_game(const Context& c, View) {
  const auto& object = c.session.game.*optional;
  return object ? value_of((*object).*member) : value_of(std::remove_cvref_t<decltype((*object).*member)>());
}
template <auto member>
constexpr auto of_challenge = of_game<&edit::Game::challenge, member>;
template <auto member>
constexpr auto of_card = of_game<&edit::Game::result, member>;
Answer challenge_deviation(const Context& c, View) {
  constexpr double kNothingThere = 1e9;  // m, if there is no track
  return number(std::min(c.find(edit::Want::deviation).deviation, kNothingThere));
}

Answer card_shows(const Context& c, View) {
  return yes_no(c.session.settings.aids->show_card && c.session.game.show_result && c.session.game.result);
}
Answer card_end(const Context& c, View) {
  return text(c.session.game.result ? base::name_of(c.session.game.result->end) : "none");
}
constexpr std::array kGameRows{
    Query{"challenge.active", kNoArgument, "", "on during a challenge.", active, kSwitch},
    Query{"challenge.name", kNoArgument, "", "Name of the challenge, empty without one.", challenge_name, kText},
    Query{"challenge.goals", kNoArgument, "", "Number of goals and limits of the challenge.", goals},
    Query{"challenge.met", kNoArgument, "", "Number of them that hold now; rules about the ride use the ghost.", met},
    Query{"challenge.passed", kNoArgument, "", "on if the challenge has been passed since it was started.", passed,
          kSwitch},
    Query{"challenge.medal", kNoArgument, "", "Best medal since it was started: 0 none, 1 bronze, 2 silver, 3 gold.",
          of_challenge<&edit::ActiveChallenge::medal>},
    Query{"challenge.judged", kNoArgument, "", "Number of judgements since it was started.",
          of_challenge<&edit::ActiveChallenge::judged>},
    Query{"challenge.failure", kNoArgument, "", "Why the last judgement failed; empty if it passed or there was none.",
          failure, kText},
    Query{"challenge.hints", kNoArgument, "", "Number of hints shown.", of_challenge<&edit::ActiveChallenge::hints>},
    Query{"challenge.deviation", kNoArgument, "m",
          "Largest distance between the track and the challenge's start track, independent of their knots; 0 without a "
          "challenge.",
          challenge_deviation},
    Query{"card.shows", kNoArgument, "", "on while a score card is shown.", card_shows, kSwitch},
    Query{"card.end", kNoArgument, "", "How the last ride ended: lap, open end, time, failed; none before the first.",
          card_end, kOneOf<edit::RideEnd>},
    Query{"card.reason", kNoArgument, "", "Why it ended, if not with a lap.", of_card<&edit::RideResult::reason>,
          kText},
    Query{"card.seconds", kNoArgument, "s", "Duration of the last ride.", of_card<&edit::RideResult::seconds>},
    Query{"card.rides", kNoArgument, "", "Number of rides that ended since the track was opened.",
          of_card<&edit::RideResult::serial>},
};

}  // namespace

std::span<const Query> game_rows() { return kGameRows; }

}  // namespace coaster::query
