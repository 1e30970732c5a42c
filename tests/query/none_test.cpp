// Which queries have no value in which states, and that no check passes on them.
#include <algorithm>
#include <set>

#include "edit/session_fixture.h"
#include "query/condition.h"
#include "query/context.h"

namespace coaster::query {
namespace none_test {

using Names = std::set<std::string>;

// Queries that are none for the same reason: written down here, not read from the rows.
const Names kFrames{"deviation_pending",
                    "upload_bytes",
                    "polyline_upload_bytes",
                    "polyline_bytes",
                    "gpu_ms",
                    "uploads",
                    "recolours",
                    "supports.uploads",
                    "park.uploads",
                    "park.upload_bytes",
                    "draw_calls",
                    "triangles",
                    "shadow_maps",
                    "samples",
                    "rebuilds",
                    "supports.count",
                    "supports.rebuilds",
                    "colour.low",
                    "colour.high",
                    "fps",
                    "cpu_ms",
                    "gl_ms",
                    "evaluation_time",
                    "width",
                    "height",
                    "movie.frames",
                    "drawn_by",
                    "camera_shown",
                    "camera_eye",
                    "camera_height",
                    "camera_forward",
                    "camera_up",
                    "camera_tilt",
                    "camera_field_of_view",
                    "ns_per_point"};
const Names kRide{"ride.lap_time",      "ride.g_up_max",     "ride.g_up_min",      "ride.g_side_max",
                  "ride.g_forward_max", "ride.g_back_max",   "ride.road_load_max", "ride.up_stop_load_max",
                  "ride.side_load_max", "ride.jerk_max",     "ride.roll_rate_max", "ride.roll_acceleration_max",
                  "ride.jolt_max",      "ride.speed_max",    "ride.envelope",      "ride.excitement",
                  "ride.intensity",     "ride.nausea",       "ride.airtime",       "ride.drops",
                  "ride.drop_max",      "ride.height_max",   "ride.near_misses",   "ride.tunnels",
                  "ride.in_tunnels",    "ride.surroundings", "ride.inversions",    "ride.ghost_end",
                  "ride.jolt_knot",     "ride.jerk",         "ride.g_step_max"};
const Names kTrain{
    "ride.state",   "ride.speed",     "ride.height",       "ride.distance", "ride.travelled", "ride.lap",
    "ride.segment", "ride.energy",    "ride.energy_drift", "ride.g_up",     "ride.g_side",    "ride.g_forward",
    "wheels.road",  "wheels.up_stop", "wheels.side",       "ride.jerk",     "ride.roll_rate", "ride.roll_acceleration",
    "cart_up",      "g_step_max"};
// At a distance that no seat reaches.
const Names kSeats{
    "seat.g_up",         "seat.g_side",    "seat.g_forward",         "seat.jerk",  "seat.jerk_up", "seat.jerk_side",
    "seat.jerk_forward", "seat.roll_rate", "seat.roll_acceleration", "seat.speed", "seat.height"};
const Names kSelection{"selected", "selected_t",         "selected_kind", "curvature",
                       "torsion",  "construction_point", "rounding",      "seam"};
const Names kChallenge{"challenge.name",   "challenge.goals",   "challenge.met",   "challenge.medal",
                       "challenge.judged", "challenge.failure", "challenge.hints", "challenge.deviation"};
const Names kResult{"card.end", "card.reason", "card.seconds"};
const Names kImport{"import.max_error", "import.frame_error", "import.rms_error", "import.rms_frame_error",
                    "import.jump_error"};
const Names kMeasured{"measure.error", "measure.time"};
const Names kOpenEnd{"geometric",   "parametric",  "gap",           "speed_ratio",      "curvature_jump",
                     "second_jump", "joint_angle", "g_step",        "curvature_before", "curvature_after",
                     "ride.g_step", "jolt",        "jolt.vertical", "jolt.lateral",     "jolt.longitudinal"};
const Names kJoint{"geometric_min",      "parametric_min", "weakest_geometric",
                   "weakest_parametric", "roughest_joint", "g_step_max"};
const Names kTrack{"longest",       "deviation",    "chord_error",     "erratum",
                   "erratum_wrong", "least_radius", "ground.clearance"};
const Names kSpeeds{"section.speed_in", "section.speed_out", "section.g_most", "section.g_least", "section.g_side"};
// Of a section that is not of forces.
const Names kForce{"force.asked",  "force.met",       "force.keys",     "force.over",  "force.of",
                   "force.length", "force.tolerance", "force.speed",    "force.error", "force.shape_error",
                   "force.hold",   "force.unmet",     "force.unmet_at", "force.ramp",  "force.stopped"};
const Names kPlan{"element.error", "element.roll_error", "element.jump",   "element.length",
                  "element.lead",  "element.lowest",     "element.missing"};
const Names kConflict{"conflict.at", "conflict.other"}, kFold{"fold.at", "fold.radius", "tight_bend.at"},
    kFails{"ride.fail", "ride.fail_distance"};
const Names kJolts{"jolt", "jolt.vertical", "jolt.lateral", "jolt.longitudinal",
                   "ride.g_step"};                                          // at knots that the ride does not pass
const Names kPark{"park.seed", "park.relief", "park.woods", "park.water"};  // without a land
const Names kWays{"complete.length", "complete.worst_g", "complete.jolt"};

Names operator+(Names a, const Names& b) {
  a.insert(b.begin(), b.end());
  return a;
}
Names operator-(Names a, const Names& b) {
  for (const std::string& name : b) a.erase(name);
  return a;
}

std::string joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += name + " ";
  return text;
}

// A session with a picture drawn and everything measured, on the fixture's open track with two trains.
class NoneTest : public test::SessionTest {
 protected:
  void SetUp() override { draw(); }
  void draw() {
    stats.frame = 3, stats.fps = 60, stats.cpu_ms = 1, stats.gl_ms = 2, stats.gpu_ms = 0.5;
    stats.evaluation_ms = 0.25, stats.evaluated_vertices = 100;
    session.measuring.ride_cost.ns_per_tick = 700;
  }
  QueryContext context() {
    return {session, stats, "", "", [](std::string_view path) { return Widget{std::string(path)}; }};
  }
  // Every argument of one kind of word: entities of the document, words, whole numbers, and two numbers.
  std::vector<std::string> words_of(const ArgumentPart& part) {
    std::vector<std::string> words = part.words ? part.words() : std::vector<std::string>();
    if (part.kind)
      for (const world::EntityName& name : session.document.entities.pool<world::EntityName>().items())
        if (name.kind == *part.kind) words.push_back("@" + world::to_text(name));
    for (int i = 1; i <= part.most; ++i) words.push_back(std::to_string(i));
    if (part.number) words = {"0", "1e6"};
    if (part.usage == "\"PATH\"") words = {"Track/Name"};
    return words;
  }
  std::vector<std::string> arguments_of(const Query& query) {
    std::vector<std::string> all{""};
    for (const ArgumentPart& part : query.argument) {
      std::vector<std::string> longer = part.optional ? all : std::vector<std::string>();
      for (const std::string& begin : all)
        for (const std::string& word : words_of(part))
          longer.push_back(part.before ? begin + part.before + word : begin + word);
      all = std::move(longer);
    }
    return all;
  }
  // The queries that are none for one of their arguments. An unmarked one fails the test.
  Names none_now() {
    Names names;
    for (const Query& query : queries())
      for (const std::string& argument : arguments_of(query)) {
        const auto value = query.evaluate(context(), argument);
        EXPECT_TRUE(value) << query.name << " " << argument << ": " << value.status().message;
        if (!value) continue;
        if (!is_none(*value)) continue;
        EXPECT_TRUE(query.values.may_be_none)
            << query.name << " " << argument << " is none, and its row does not say so";
        names.insert(std::string(query.name));
      }
    return names;
  }
  // Compares what is none now with a list, and remembers it.
  void expect_none(const std::string& state, const Names& wanted) {
    const Names now = none_now();
    EXPECT_EQ(joined(now - wanted), "") << state << ": none, but not in the list";
    EXPECT_EQ(joined(wanted - now), "") << state << ": in the list, but has a value";
    seen = seen + now;
  }
  FrameStats stats;
  Names seen;
};

TEST_F(NoneTest, each_query_is_none_in_exactly_the_states_where_it_has_no_answer) {
  // Whatever the state: an element lacks some parameter, there are fewer than three closing sections, no ride has
  // failed.
  const Names always = kSeats + kFails + kWays + kPark + Names{"element.value"};
  const Names untouched = kSelection + kChallenge + kResult + kImport + kMeasured;

  // An open track of five knots in one section, with two trains that start on its second and its last segment.
  const Names open = always + untouched + kOpenEnd + kForce + kConflict + kFold + kSpeeds +
                     Names{"ride.lap_time", "loop_twist", "element.refusal", "section.value", "equipment"};
  expect_none("open", open);

  stats = {};
  expect_none("no frame", open + kFrames);
  draw();
  session.measuring.ride_cost = {};
  expect_none("no tick", open + Names{"ride.cost"});
  draw();
  good("element.choose straight");
  expect_none("no side", open + Names{"element.side"});
  good("element.choose loop");

  // A segment selected, a challenge, a result, an import and a measurement.
  good("select @s2 at 0.3");
  session.game.challenge.emplace().shape = sim::trace_of(session.document);
  session.game.result.emplace();
  session.file.import.emplace();
  for (const std::string& name : base::names_of<curve::EvaluatorId>()) {
    sim::MeasuredRow row{.evaluator = *base::value_named<curve::EvaluatorId>(name), .cells = {}};
    for (sim::MeasuredCell& cell : row.cells) cell.rounds = 1;
    session.measuring.measurement.rows.push_back(row);
  }
  expect_none("all there", (open - untouched) + Names{"measure.time"});  // of shaders
  session.game = {}, session.file.import = {}, session.measuring.measurement = {};

  good("select none");
  good("remove @c1");
  good("remove @c2");
  expect_none("no train", open + kTrain + kRide + Names{"erratum", "erratum_wrong"});

  start_on(world::Document{});
  draw();
  const Names nothing = always + untouched + kConflict + kFold + kTrain + kRide + kJoint + kTrack +
                        Names{"loop_twist", "element.refusal", "open_end.distance"};
  expect_none("empty", nothing + Names{"roll_max"});
  good("append at 0 2 0");
  expect_none("one knot", nothing + kOpenEnd - Names{"selected", "selected_kind"});

  circuit();
  good("select none");
  draw();
  const Names closed = always + untouched + kConflict + kFold + kPlan + kForce + Names{"section.value", "equipment"};
  expect_none("circuit", closed + Names{"ride.ghost_end"});
  good("park hills");
  expect_none("park", (closed - kPark) + Names{"ride.ghost_end"});
  good("section.earthwork all to none");
  good("park.water none");
  expect_none("no water", (closed - kPark) + Names{"ride.ghost_end", "park.water", "section.earthwork"});
  good("undo"), good("undo"), good("undo");
  good("losses rolling 0.1 drag 0.01");
  expect_none("no lap", closed + kSpeeds + kJolts + Names{"ride.lap_time"});
  good("undo");
  good("undo");
  good("select none");
  expect_none("way home", (closed - kPlan - kWays) + kOpenEnd +
                              Names{"ride.lap_time", "loop_twist", "element.refusal", "complete.refusal"});

  good("new");  // a cusp: handles of the chord's length that cross
  for (const char* line : {"append at 0 10 0", "append at 20 10 0", "direct @k1 to 1 0 1", "direct @k2 to 1 0 -1",
                           "lengths @k1 in 28.284271247461902 out 28.284271247461902",
                           "lengths @k2 in 28.284271247461902 out 28.284271247461902"})
    good(line);
  const Names cusp = none_now();
  EXPECT_EQ(cusp.count("twist"), 1u);
  seen = seen + cusp;

  for (const Query& query : queries())
    EXPECT_TRUE(!query.values.may_be_none || seen.count(std::string(query.name)) > 0) << query.name << " is never none";
}

}  // namespace none_test
}  // namespace coaster::query
