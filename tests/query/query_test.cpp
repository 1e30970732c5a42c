#include "query/query.h"

#include <set>

#include "base/hash.h"
#include "edit/session_fixture.h"
#include "query/context.h"
#include "sim/solids/conflict_types.h"

namespace coaster::query {
namespace query_test {

class QueryTest : public test::SessionTest {
 protected:
  base::Result<Value> ask(std::string_view name, std::string_view argument = {}) {
    const Query* const query = find_query(name);
    EXPECT_TRUE(query) << name;
    if (!query) return base::Status{base::Code::usage, "no query"};
    return query->evaluate({session, stats, toast, title}, argument);
  }
  double number(std::string_view name, std::string_view argument = {}) {
    const auto value = ask(name, argument);
    EXPECT_TRUE(value) << name << ": " << value.status().message;
    return value ? std::get<double>(*value) : NAN;
  }
  std::string words(std::string_view name, std::string_view argument = {}) {
    const auto value = ask(name, argument);
    EXPECT_TRUE(value) << name << ": " << value.status().message;
    return value ? to_text(*value) : "";
  }
  int rank(std::string_view name, std::string_view argument = {}) {
    return std::get<Ranked>(*ask(name, argument)).rank;
  }

  QueryContext context() {
    return {session, stats, toast, title, [](std::string_view path) { return Widget{std::string(path)}; }};
  }

  FrameStats stats;
  std::string toast, title;
};

// An argument that the query accepts: entities of the fixture, and of each set the last word.
std::string sample_argument(const Query& query) {
  std::string sample;
  for (const ArgumentPart& part : query.argument) {
    if (part.before != 0) sample += part.before;
    if (part.kind == world::EntityKind::segment) sample += "@s3";
    else if (part.kind) sample += "@" + world::to_text({*part.kind, part.kind == world::EntityKind::knot ? 2u : 1u});
    else if (part.usage == "\"PATH\"") sample += "Track/Name";
    else sample += part.words ? part.words().back() : part.number ? "7.5" : std::to_string(part.most);
  }
  EXPECT_FALSE(query.argument.size() > 0 && wrong_argument(query.argument, sample)) << query.name << " " << sample;
  return sample;
}

// A query's values are what its row says: texts and ranks among its words, numbers or none.
void check_type(const Query& query, const std::string& argument, const Value& value) {
  const auto [type, words] = values_with(query, argument);
  const bool none = is_none(value);
  if (!none) {
    const ValueType found[] = {ValueType::number, ValueType::text, ValueType::ranked,
                               ValueType::vector};  // in the order of Value's types
    EXPECT_EQ(static_cast<int>(type), static_cast<int>(found[value.index()])) << query.name;
  }
  if (words.empty() || none) return;
  const auto place = std::find(words.begin(), words.end(), to_text(value));
  EXPECT_NE(place, words.end()) << query.name << " is " << to_text(value);
  if (const Ranked* const ranked = std::get_if<Ranked>(&value)) {
    EXPECT_EQ(ranked->rank, place - words.begin()) << query.name;
  }
}

TEST(values, whole_numbers_are_printed_as_people_write_them) {
  EXPECT_EQ(to_text(100'000.0), "100000");
  EXPECT_EQ(to_text(-2'000'000.0), "-2000000");
  EXPECT_EQ(to_text(-0.0), "0");
  EXPECT_EQ(to_text(0.25), "0.25");
  EXPECT_EQ(to_text(1e300), "1e+300");
}

TEST_F(QueryTest, every_row_has_a_value_on_a_track_and_on_an_empty_one) {
  for (const Query& query : queries()) {
    const auto value = query.evaluate(context(), sample_argument(query));
    ASSERT_TRUE(value) << query.name << ": " << value.status().message;
    if (const double* real = std::get_if<double>(&*value)) {
      EXPECT_TRUE(std::isfinite(*real)) << query.name;
    }
    EXPECT_FALSE(query.text.empty()) << query.name;
    check_type(query, sample_argument(query), *value);
  }
  good("new");
  for (const Query& query : queries())
    EXPECT_EQ(query.evaluate(context(), sample_argument(query)).ok(), !usage_of(query.argument).starts_with('@'))
        << query.name;
}

TEST_F(QueryTest, names_are_unique_and_found) {
  std::set<std::string_view> names;
  for (const Query& query : queries()) {
    EXPECT_TRUE(names.insert(query.name).second) << query.name;
    EXPECT_EQ(find_query(query.name), &query);
  }
  EXPECT_EQ(find_query("knotz"), nullptr);
  EXPECT_EQ(find_query(""), nullptr);
}

TEST_F(QueryTest, the_names_that_scripts_rely_on_are_there) {
  for (const char* name :
       {"knots",          "segments",      "closed",   "length",      "exact_length",      "evaluator",  "resolution",
        "frames_by",      "name",          "position", "geometric",   "parametric",        "gap",        "hash",
        "vertices",       "uploads",       "rebuilds", "deviation",   "chord_error",       "ride.state", "ride.speed",
        "ride.height",    "ride.distance", "ride.lap", "ride.energy", "ride.energy_drift", "ride.g_up",  "ride.g_side",
        "ride.g_forward", "frame",         "tick",     "selected",    "undo_depth",        "toast",      "title"})
    EXPECT_TRUE(find_query(name)) << name;
}

TEST_F(QueryTest, the_document_reads_as_it_is) {
  EXPECT_EQ(number("knots"), 5);
  EXPECT_EQ(number("segments"), 4);
  EXPECT_EQ(words("closed"), "off");
  EXPECT_EQ(rank("closed"), 0);
  good("closed on");
  EXPECT_EQ(rank("closed"), 1);
  EXPECT_EQ(words("closed"), "on");
  EXPECT_EQ(words("name"), "Skew \"sample\"");
  EXPECT_EQ(number("start_speed"), 3.3);
  EXPECT_EQ(number("datum"), -1.7);
  EXPECT_EQ(words("joint", "@k1"), "smooth");
  EXPECT_EQ(words("joint", "@k4"), "automatic");
  EXPECT_EQ(number("turns", "@s3"), -1);
  EXPECT_NEAR(number("roll", "@k2"), 23.7, 1e-4);
  EXPECT_FLOAT_EQ(static_cast<float>(number("in_length", "@k2")), 6.3f);
  EXPECT_FLOAT_EQ(static_cast<float>(number("out_length", "k2")), 9.7f);
  const auto position = std::get<glm::dvec3>(*ask("position", "@k3"));
  EXPECT_EQ(position, glm::dvec3(149.9f, 7.7f, -11.3f));
  EXPECT_EQ(words("vertices"), "325");
  EXPECT_EQ(number("carts"), 2);
}

TEST_F(QueryTest, lengths_are_by_the_chosen_method_and_exact) {
  double exact = 0;
  for (const world::Entity e : session.document.track.segments)
    exact += curve::arc_length(world::cubic_of(session.document, e));
  EXPECT_NEAR(number("length"), exact, 1e-9);
  good("resolution 2");
  good("arc_length " + std::string(curve::arc_length_methods()[2].name));
  double chords = 0, third = 0;
  for (const world::Entity e : session.document.track.segments) {
    const curve::Cubic c = world::cubic_of(session.document, e);
    const double sum = glm::distance(curve::point(c, 0), curve::point(c, 0.5)) +
                       glm::distance(curve::point(c, 0.5), curve::point(c, 1));
    chords += sum;
    if (e == session.document.track.segments[2]) third = sum;
  }
  EXPECT_NEAR(number("length"), chords, 1e-3);
  EXPECT_NEAR(number("segment_length", "@s3"), third, 1e-3);
  EXPECT_NEAR(number("exact_length"), exact, 1e-9);
  EXPECT_EQ(words("arc_length"), curve::arc_length_methods()[2].name);
}

TEST_F(QueryTest, the_conflict_is_the_worst_wherever_it_is) {
  for (const char* heights : {"0 1", "1 0"}) {
    start_on(world::Document{});
    const std::string first(1, heights[0]), second(1, heights[2]);
    for (const std::string& at :
         std::vector<std::string>{"0 9 0", "100 9 0", "130 9 30", "80 1" + first + " 40", "80 1" + first + " -40",
                                  "30 1" + second + " -40", "30 1" + second + " 40"})
      good("append at " + at);
    ASSERT_GE(number("conflicts"), 2);
    double most = 0, at = 0;
    for (const sim::Conflict& conflict : edit::SessionFindings(session).conflicts())
      if (conflict.missing > most) most = conflict.missing, at = conflict.at;
    EXPECT_EQ(number("conflict.missing"), most) << heights;
    EXPECT_EQ(number("conflict.at"), at) << heights;
  }
}

TEST_F(QueryTest, continuity_compares_by_rank) {
  EXPECT_EQ(words("geometric", "@k1"), "none");  // an end of an open track
  EXPECT_EQ(words("geometric", "@k5"), "none");
  EXPECT_GE(rank("geometric", "@k2"), 2);
  EXPECT_EQ(words("parametric", "@k2"), "C0");  // 6.3 m and 9.7 m
  EXPECT_EQ(rank("parametric", "@k2"), 1);
  EXPECT_EQ(number("gap", "@k2"), 0);
  EXPECT_NEAR(number("speed_ratio", "@k2"), 9.7 / 6.3, 1e-5);
  good("lengths @k2 in 8 out 8");
  EXPECT_EQ(rank("parametric", "@k2"), 2);
  EXPECT_EQ(words("parametric", "@k2"), "C1");
}

TEST_F(QueryTest, words_have_the_ranks_of_the_values_they_name) {
  for (const char* name : {"geometric", "parametric"})
    for (const char* knot : {"@k2", "@k3", "@k4"})
      EXPECT_EQ(rank_of(*find_query(name), words(name, knot)), rank(name, knot)) << name << knot;
  for (const char* name : {"closed", "dirty", "panels", "polyline"})
    EXPECT_EQ(rank_of(*find_query(name), words(name)), rank(name)) << name;
  const auto ranks = [](std::string_view name, std::vector<std::string_view> ascending) {
    for (std::size_t i = 0; i + 1 < ascending.size(); ++i)
      EXPECT_LT(rank_of(*find_query(name), ascending[i]), rank_of(*find_query(name), ascending[i + 1])) << ascending[i];
  };
  ranks("geometric", {"none", "G0", "g1", "G2"});
  ranks("parametric", {"None", "C0", "C1", "c2"});
  for (const char* yes : {"on", "TRUE", "yes", "1"}) EXPECT_EQ(rank_of(*find_query("closed"), yes), 1) << yes;
  for (const char* no : {"off", "false", "No", "0"}) EXPECT_EQ(rank_of(*find_query("closed"), no), 0) << no;
  EXPECT_EQ(rank_of(*find_query("geometric"), "C1"), std::nullopt);
  EXPECT_EQ(rank_of(*find_query("parametric"), "on"), std::nullopt);
  EXPECT_EQ(rank_of(*find_query("closed"), "maybe"), std::nullopt);
  EXPECT_EQ(rank_of(*find_query("closed"), ""), std::nullopt);
}

TEST_F(QueryTest, missing_entities_are_refused_with_a_suggestion) {
  const auto refused = [&](std::string_view name, std::string_view argument, std::string_view part) {
    const auto value = ask(name, argument);
    ASSERT_FALSE(value) << name;
    EXPECT_EQ(value.status().code, base::Code::refused);
    EXPECT_NE(value.status().message.find(part), std::string::npos) << value.status().message;
  };
  refused("position", "@k9", "no knot @k9");
  refused("position", "@k9", "did you mean");
}

TEST_F(QueryTest, without_panels_no_widget_has_a_text) {
  EXPECT_EQ(ask("text", "Track/Name").status().message, "there are no panels");
}

TEST_F(QueryTest, hashes_are_those_of_the_world) {
  EXPECT_EQ(words("hash", "document"), base::hex16(world::hash(session.document)));
  EXPECT_EQ(words("hash", "motion"), base::hex16(world::hash(session.document, session.motion)));
  const std::string before = words("hash", "motion");
  good("ride.start");
  edit::advance(session, 10);
  EXPECT_NE(words("hash", "motion"), before);
  EXPECT_EQ(words("hash", "document").size(), 16u);
}

TEST_F(QueryTest, the_ride_is_that_of_the_selected_cart_or_the_first) {
  EXPECT_EQ(words("ride.state"), "stopped");
  EXPECT_EQ(number("ride.speed"), 3.3);
  EXPECT_EQ(words("ride.segment"), "s2");
  good("select @c2");
  EXPECT_EQ(words("ride.segment"), "s4");
  const double height = number("ride.height");
  EXPECT_NEAR(number("ride.energy"), 0.5 * 3.3 * 3.3 + 9.81 * (height + 1.7), 1e-9);
  EXPECT_NEAR(number("ride.distance"), session.derived.starts[3] + 0.91 * number("segment_length", "@s4"), 1e-9);
  good("remove @c1");
  good("select none");
  EXPECT_EQ(words("ride.segment"), "s4");
  good("ride.start");
  EXPECT_EQ(words("ride.state"), "running");
  good("remove @c2");
  EXPECT_EQ(words("ride.state"), "none");
  EXPECT_EQ(words("ride.speed"), "none");
  EXPECT_EQ(words("ride.g_up"), "none");
}

TEST_F(QueryTest, the_session_reads_as_it_is) {
  EXPECT_EQ(words("selected"), "none");
  EXPECT_EQ(words("dirty"), "off");
  EXPECT_EQ(number("undo_depth"), 0);
  good("select @s2 at 0.37");
  good("move @k4 to 1.5 2.25 3");
  EXPECT_EQ(words("selected"), "s2");
  EXPECT_EQ(number("selected_t"), 0.37);
  EXPECT_EQ(number("undo_depth"), 1);
  EXPECT_EQ(words("dirty"), "on");
  EXPECT_EQ(words("position", "@k4"), "1.5 2.25 3");
  good("undo");
  EXPECT_EQ(number("undo_depth"), 0);
  EXPECT_EQ(number("redo_depth"), 1);
  good("camera target 1 2 3 yaw 17 pitch 23 distance 31");
  EXPECT_EQ(number("camera_yaw"), 17);
  EXPECT_EQ(number("camera_pitch"), 23);
  EXPECT_EQ(number("camera_distance"), 31);
  good("panels off");
  EXPECT_EQ(words("panels"), "off");
  good("append_mode on");
  EXPECT_EQ(words("append_mode"), "on");
  for (const char* line : {"evaluator bernstein", "frames_by frenet", "integrator verlet"}) {
    good(line);
    const std::string_view text(line);
    const std::size_t blank = text.find(' ');
    EXPECT_EQ(words(text.substr(0, blank)), text.substr(blank + 1));
  }
}

TEST_F(QueryTest, frame_numbers_are_those_of_the_frame_loop) {
  stats.frame = 42, stats.uploads = 2, stats.rebuilds = 3, stats.recolours = 4, stats.draw_calls = 17,
  stats.samples = 8;
  stats.triangles = 123'456, stats.shadow_maps = 1;
  stats.evaluation_ms = 0.5, stats.evaluated_vertices = 1000, stats.fps = 59.9, stats.cpu_ms = 1.7;
  toast = "At the limit", title = "Skew - coaster";
  EXPECT_EQ(number("frame"), 42);
  EXPECT_EQ(number("uploads"), 2);
  EXPECT_EQ(number("rebuilds"), 3);
  EXPECT_EQ(number("recolours"), 4);
  EXPECT_EQ(number("draw_calls"), 17);
  EXPECT_EQ(number("triangles"), 123'456);
  EXPECT_EQ(number("shadow_maps"), 1);
  EXPECT_EQ(number("samples"), 8);
  EXPECT_DOUBLE_EQ(number("ns_per_point"), 500);
  EXPECT_EQ(number("evaluation_time"), 0.5);
  EXPECT_EQ(number("fps"), 59.9);
  EXPECT_EQ(number("cpu_ms"), 1.7);
  EXPECT_EQ(words("toast"), toast);
  EXPECT_EQ(words("title"), title);
}

}  // namespace query_test
}  // namespace coaster::query
