// The same document, commands and ticks give the same hashes on every compiler and build: the expected values are in
// this file.
#include <gtest/gtest.h>

#include "base/hash.h"
#include "edit/commands/codec.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "exchange/nolimits/nl2_csv.h"

namespace coaster {
namespace determinism_test {

std::string sample(const std::string& name) { return std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json"; }

// Applies lines of text as a script would; every one must succeed.
void run(edit::Session& session, base::Files& files, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    std::vector<base::Token> tokens;
    base::TextError error;
    ASSERT_TRUE(base::tokenise(line, tokens, error)) << line;
    auto command = edit::parse(tokens, error);
    ASSERT_TRUE(command.ok()) << line << ": " << error.message;
    const base::Status status = edit::apply(session, files, *command);
    ASSERT_TRUE(status.ok()) << line << ": " << status.message;
  }
}

edit::Session open_sample(base::Files& files, const std::string& name) {
  edit::Session session = edit::make_session({});
  run(session, files, {"load " + base::quoted(sample(name))});
  return session;
}

struct Hashes {
  std::string document, motion;
  friend bool operator==(const Hashes&, const Hashes&) = default;
};
std::ostream& operator<<(std::ostream& out, const Hashes& h) { return out << h.document << " " << h.motion; }

Hashes hashes(const edit::Session& session) {
  return {base::hex16(world::hash(session.document)), base::hex16(world::hash(session.document, session.motion))};
}

struct Expected {
  const char* name;
  Hashes after_ride, after_edits;
};
const Expected kExpected[] = {
    {"loop", {"e9694c1f6b5ae3e6", "c0d57203d30ffa48"}, {"9cfd908fabd673bf", "4f647c2bc112e38c"}},
    {"helix", {"48d5c0fdf580d51c", "b7eb885537471420"}, {"bc02f609786dab94", "415abfc6a070c6d3"}},
    {"gentle", {"b9c41037268b80c7", "204a4b8602942cc0"}, {"fa46a7a348c0032d", "7ca1e3ab50337cb3"}},
};

// A ride of 20 s, with edits under the moving cart half way.
Hashes ride(const char* name, bool toggle, bool edits) {
  base::Files files;
  edit::Session session = open_sample(files, name);
  run(session, files, {"ride.start"});
  edit::advance(session, 1200);
  if (edits)
    run(session, files,
        {"move @k3 to 44.25 4.5 1.75", "split @s2 at 0.4", "roll @k4 to 17.5", "handle @k5.out to 61 22 -1.5",
         "lengths @k6 in 3.25 out 4.5", "remove @k8", "add_curve", "turns @s9 to 1", "joint @k10 to automatic"});
  for (int i = 0; i < 12; ++i) {
    if (toggle)
      run(session, files, {"evaluator forward_differences", "resolution 7", "evaluator horner", "frames_by frenet"});
    edit::advance(session, 100);
  }
  return hashes(session);
}

TEST(determinism, the_hashes_of_the_samples_are_those_written_down) {
  for (const Expected& expected : kExpected) {
    EXPECT_EQ(ride(expected.name, false, false), expected.after_ride) << expected.name;
    EXPECT_EQ(ride(expected.name, false, true), expected.after_edits) << expected.name;
  }
}

// Every integrator with a train, losses and equipment, and with banking by the simulated ride: all that moves a cart.
TEST(determinism, every_integrator_moves_a_train_to_the_hashes_written_down) {
  const std::pair<const char*, const char*> expected[] = {
      {"rk4", "f807935ebd8f49f5"},   {"verlet", "86133dbbdd6b2004"},      {"energy", "8a1ebfe5c4585e4b"},
      {"euler", "1182eec9ec6592ff"}, {"precomputed", "e678bac8913e40d7"}, {"vertices", "82c1c075ccc222ae"}};
  for (const auto& [row, motion] : expected) {
    base::Files files;
    edit::Session session = open_sample(files, "loop");
    run(session, files,
        {"train @c1 cars 5 spacing 2.75 mass 640", "losses rolling 0.004 drag 0.00003",
         "equip @s1 as launch speed 12 acceleration 3", "equip @s27 as brake speed 6 acceleration 4", "auto_bank",
         std::string("integrator ") + row, "ride.start"});
    edit::advance(session, 3600);
    EXPECT_EQ(hashes(session).motion, motion) << row << " at " << session.motion.carts.items().at(0).travelled << " m";
    EXPECT_GT(session.motion.carts.items().at(0).travelled, 200) << row;
  }
}

TEST(determinism, the_evaluator_and_the_resolution_change_neither_document_nor_motion) {
  for (const Expected& expected : kExpected)
    EXPECT_EQ(ride(expected.name, true, true), ride(expected.name, false, true));
}

TEST(determinism, a_saved_and_loaded_sample_rides_the_same) {
  base::Files files;
  for (const Expected& expected : kExpected) {
    edit::Session session = open_sample(files, expected.name);
    const std::string path = testing::TempDir() + "determinism_" + expected.name + ".json";
    run(session, files, {"save " + base::quoted(path), "load " + base::quoted(path), "ride.start"});
    edit::advance(session, 2400);
    EXPECT_EQ(hashes(session), expected.after_ride) << expected.name;
  }
}

TEST(determinism, the_default_integrator_keeps_the_energy_over_ten_laps_of_each_sample) {
  base::Files files;
  for (const Expected& expected : kExpected) {
    edit::Session session = open_sample(files, expected.name);
    run(session, files, {"ride.start"});
    double worst = 0;
    for (int tick = 0; tick < 120 * 1200; tick += 7) {
      edit::advance(session, 7);
      const world::TrainMotion& cart = session.motion.carts.items().at(0);
      worst = std::max(
          worst, sim::energy_drift(session.document, session.derived, session.motion.carts.entities().at(0), cart));
      if (cart.laps == 10) break;
    }
    EXPECT_EQ(session.motion.carts.items().at(0).laps, 10) << expected.name;
    EXPECT_LT(worst, 1e-6) << expected.name;
    EXPECT_GT(session.motion.carts.items().at(0).peak_kinetic, 50) << expected.name;
    RecordProperty(expected.name, std::to_string(worst));
    std::printf("%s: largest energy drift over 10 laps %.2e\n", expected.name, worst);
  }
}

// A track that is fitted to rows has the same bits, too: its knots are part of the document's hash.
TEST(determinism, an_imported_track_is_one_document_everywhere) {
  const std::pair<const char*, const char*> expected[] = {
      {"loop", "09c54cc0117ba452"}, {"helix", "d09628e11fd6f038"}, {"gentle", "f502ddb3c0d83348"}};
  for (const auto& [name, hash] : expected) {
    base::Files files;
    const edit::Session session = open_sample(files, name);
    const auto back = exchange::parse_nl2_csv(exchange::print_nl2_csv(session.document, 0.25), "t.csv");
    ASSERT_TRUE(back.ok()) << name;
    EXPECT_EQ(base::hex16(world::hash(back->document)), hash) << name;
  }
}

// Every command that shapes several knots, with numbers that leave no bit of a float at rest.
TEST(determinism, shaping_several_knots_gives_one_document_everywhere) {
  base::Files files;
  edit::Session session = open_sample(files, "loop");
  run(session, files,
      {"rotate @k2,@k3,@k4 by 17.3 about 40.1 3.7 2.9 axis 0.3 0.9 -0.2", "translate @k5,@k6 by 0.123 -0.456 0.789",
       "scale_knots @k7,@k8 by 1.1 0.9 1.3 about 30.3 5.5 -1.7", "mirror @k3,@k4 across 0.7 0.1 0.6 about 41.7 6.1 0.3",
       "smooth @k2,@k3,@k4,@k5", "smooth @k7,@k8 by uniform", "radius @k6 to 23.7", "straighten @k8,@k9,@k10",
       "equalise @k5,@k6", "drop @k9 to 1.3", "align @k2,@k8 axis z to 0.77", "reverse", "closed off",
       "duplicate @k5,@k6,@k7", "close within 0.5"});
  EXPECT_EQ(base::hex16(world::hash(session.document)), "4947ee125d398e46");
}

}  // namespace determinism_test
}  // namespace coaster
