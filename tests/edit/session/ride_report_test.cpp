// Tests the ride report (edit/session/ride_report.h).
#include "edit/session/ride_report.h"

#include <cmath>
#include <set>
#include <sstream>

#include "base/scratch_folder.h"
#include "edit/session_fixture.h"
#include "exchange/own/json.h"

namespace coaster::edit {
namespace ride_report_test {

class RideReport : public test::SessionTest {
 protected:
  exchange::Json json() {
    const auto text = ride_report_json(session);
    EXPECT_TRUE(text.has_value());
    return exchange::Json::parse(text.value_or("null"));
  }
  std::string text() { return ride_report(session).value_or(""); }
  void open(const std::string& name) { good("load " + std::string(COASTER_SOURCE_DIR) + "/" + name); }
};

// Calls visit(value) for each number below a tree.
template <class Visit>
void visit_numbers(const exchange::Json& tree, Visit visit) {
  if (tree.is_number()) visit(tree.get<double>());
  if (tree.is_structured())
    for (const exchange::Json& part : tree) visit_numbers(part, visit);
}

// A track whose ends meet at once, with handles of a centimetre between knots 50 km apart.
constexpr std::string_view kFar =
    R"({"format": "coaster-track", "version": 3, "name": "Far", "closed": true, "start_speed": 31, "datum": 100000,
"rolling": 0.5, "drag": 1e-05, "heartline": 3, "knots": [
{"id": "k1", "position": [-2200, -21800, 14900], "tangent": [-0.71, -0.242, 0.661], "up": [0.666, -0.535, 0.519],
 "joint": "aligned", "in": 7600, "out": 7600},
{"id": "k2", "position": [-31000, 2100, -13100], "tangent": [0.936, 0.258, -0.239], "up": [0.172, 0.257, 0.951],
 "joint": "aligned", "in": 500, "out": 10000},
{"id": "k3", "position": [-6500, 27100, -5700], "tangent": [-0.707, 0.506, 0.495], "up": [0.592, 0.039, 0.805],
 "joint": "aligned", "in": 0.01, "out": 0.01}],
"segments": [{"id": "s1", "from": "k1", "to": "k2", "turns": 0}, {"id": "s2", "from": "k2", "to": "k3", "turns": -1},
 {"id": "s3", "from": "k3", "to": "k1", "turns": 0}],
"sections": [{"id": "q1", "segments": 3, "kind": "free"}],
"carts": [{"id": "c1", "segment": "s2", "fraction": 0.999999, "cars": 1, "spacing": 20, "length": 2.2, "mass": 100000}]})";

TEST_F(RideReport, figures_at_their_limit_say_so) {
  const test::ScratchFolder scratch;
  ASSERT_TRUE(base::Files().write_atomic(scratch.path() / "far.json", kFar));
  good("load " + (scratch.path() / "far.json").string());
  const std::string report = text(), table = ride_csv(session).value_or("");
  for (const std::string_view row :
       {"largest jolt           over 1,000 g ", "most vertical          over 1,000 g ",
        "least vertical         under -1,000 g ", "most on road wheels    over 10,000 kN "})
    EXPECT_NE(report.find(row), std::string::npos) << report;
  for (const std::string& all : {report, table, ride_report_json(session).value_or("inf")})
    EXPECT_TRUE(all.find("inf") == std::string::npos && all.find("nan") == std::string::npos) << all.substr(0, 4000);
  std::istringstream lines(table);
  std::string line, cell;
  std::getline(lines, line);
  for (int cells = 0; std::getline(lines, line) && cells < 20'000;) {
    std::istringstream row(line);
    for (int column = 0; std::getline(row, cell, ','); ++column, ++cells)
      EXPECT_TRUE(column < 5 || column > 7 || std::abs(std::stod(cell)) <= 1000) << line;
  }
  const exchange::Json tree = json();
  EXPECT_EQ(tree["largest_jolt_g"], 1000);
  std::set<std::string> over;
  for (const exchange::Json& figure : tree["over_limit"]) over.insert(figure["figure"]);
  EXPECT_TRUE(over.contains("largest_jolt_g") && over.contains("most_on_road_wheels_kN")) << tree["over_limit"];
  open("tracks/loop.json");
  EXPECT_TRUE(json()["over_limit"].empty());
}

// The text rounds to as many digits as it prints, so each of its numbers is one of the JSON's, rounded as much.
TEST_F(RideReport, the_json_has_every_number_of_the_text) {
  for (const char* const track : {"tracks/loop.json", "tests/tracks/two_knots.json"}) {
    open(track);
    std::vector<double> numbers;
    visit_numbers(json(), [&](double value) { numbers.push_back(value); });
    std::string report = text();
    report.erase(0, report.find('\n'));  // the name
    for (const std::string_view noise : {"(docs/ride.md)", "(force limits by duration; not a compliance check)", ".."})
      for (std::size_t at; (at = report.find(noise)) != std::string::npos;) report.replace(at, noise.size(), " ");
    int seen = 0;
    std::istringstream words(report);
    for (std::string word; words >> word;) {
      while (word.ends_with(',')) word.pop_back();
      const auto value = base::parse_double(word);
      if (!value) continue;
      ++seen;
      const std::size_t point = word.find('.');
      const auto digits = point == std::string::npos ? 0 : static_cast<int>(word.size() - point - 1);
      const double step = 0.5001 * std::pow(10.0, -digits);
      const bool found =
          std::any_of(numbers.begin(), numbers.end(), [&](double n) { return std::abs(n - *value) <= step; });
      const auto overloads = static_cast<double>(json()["overloads"].size());
      EXPECT_TRUE(found || *value == overloads) << track << ": " << word << " in\n" << report;
    }
    EXPECT_GT(seen, 60);
  }
}

TEST_F(RideReport, names_carry_units_and_none_is_null) {
  open("tracks/loop.json");
  const exchange::Json loop = json();
  for (const char* const name : {"length_m",
                                 "lap_s",
                                 "time_s",
                                 "cars",
                                 "spacing_m",
                                 "mean_speed_m_s",
                                 "cutoff_Hz",
                                 "top_speed_m_s",
                                 "top_speed_at_m",
                                 "top_speed_at_s",
                                 "top_speed_car",
                                 "lowest_m",
                                 "most_vertical_g",
                                 "most_on_road_wheels_kN",
                                 "most_on_up_stops_kN",
                                 "most_jerk_g_s",
                                 "most_roll_rate_deg_s",
                                 "most_roll_acceleration_deg_s2",
                                 "largest_jolt_g",
                                 "airtime_s",
                                 "drops",
                                 "highest_drop_m",
                                 "inversions",
                                 "excitement",
                                 "nausea"})
    EXPECT_TRUE(loop.contains(name) && loop[name].is_number()) << name;
  EXPECT_EQ(loop["lap_s"].get<double>(), SessionFindings(session).ratings().seconds);
  EXPECT_EQ(loop["most_jerk_car"].get<int>() >= 1, true);
  for (const char* const name : {"end", "end_m", "missed_forces", "largest_deviation_mm", "rms_deviation_deg"})
    EXPECT_TRUE(loop.contains(name) && loop[name].is_null()) << name;
  good("start_speed 0"), good("closed off");
  good("roll @k9 to 80");
  open("tests/tracks/two_knots.json");
  const exchange::Json open_track = json();
  EXPECT_TRUE(open_track["lap_s"].is_null());
  EXPECT_TRUE(open_track["end"].is_string());
  EXPECT_TRUE(open_track["time_s"].is_number());
}

TEST_F(RideReport, overloads_are_a_list_in_the_order_of_the_text) {
  open("tracks/loop.json");
  session.limits.loaded = sim::default_envelope();
  session.limits.loaded->curves[static_cast<std::size_t>(sim::ForceAxis::down)] = {{0.2, 1.5}};
  session.limits.loaded->curves[static_cast<std::size_t>(sim::ForceAxis::lift)] = {{0.2, 0.1}};
  const std::span<const sim::Overload> overloads = SessionFindings(session).overloads();
  const exchange::Json list = json()["overloads"];
  ASSERT_GT(list.size(), 2u);
  ASSERT_EQ(list.size(), overloads.size());
  std::set<std::string> axes;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const sim::Overload& span = overloads[i];
    EXPECT_EQ(list[i]["car"].get<int>(), span.car + 1);
    EXPECT_EQ(list[i]["worst_g"].get<double>(), sim::signed_g(span.axis, span.worst));
    EXPECT_EQ(list[i]["from_s"].get<double>(), span.from);
    EXPECT_EQ(list[i]["to_m"].get<double>(), span.to_distance);
    axes.insert(list[i]["axis"].get<std::string>());
  }
  EXPECT_TRUE(axes.contains("down"));
}

TEST_F(RideReport, without_a_train_there_is_none) {
  good("new");
  EXPECT_FALSE(ride_report_json(session).has_value());
}

}  // namespace ride_report_test
}  // namespace coaster::edit
