#include "world/selection.h"

#include <gtest/gtest.h>

#include "world/sample_documents.h"
#include "world/topology.h"

namespace coaster::world {
namespace selection_test {

TEST(selection, the_active_knot_is_the_last_of_the_selected_ones) {
  const Document d = test::sample_document();
  const std::vector<Entity>& k = d.track.knots;
  Settings settings;
  EXPECT_TRUE(selected_knots(d, settings).empty());
  settings.selected = k[1], settings.also = {k[3], k[0]};
  EXPECT_EQ(selected_knots(d, settings), (std::vector<Entity>{k[3], k[0], k[1]}));
  for (std::size_t i = 0; i < k.size(); ++i) EXPECT_EQ(is_selected(settings, k[i]), i == 0 || i == 1 || i == 3) << i;
  settings.also.clear();
  settings.selected = d.track.segments[2];
  EXPECT_TRUE(selected_knots(d, settings).empty()) << "a segment is none";
}

TEST(selection, chosen_knots_come_once_each_in_the_order_of_the_track) {
  const Document d = test::sample_document();
  const std::vector<Entity>& k = d.track.knots;
  EXPECT_EQ(in_track_order(d, {k[4], k[1], d.track.segments[0], k[4], k[0]}), (std::vector<Entity>{k[0], k[1], k[4]}));
  EXPECT_TRUE(in_track_order(d, {}).empty());
}

TEST(selection, a_removed_knot_is_forgotten_and_another_takes_its_place) {
  Document d = test::sample_document();
  const std::vector<Entity> k = d.track.knots;
  Settings settings;
  settings.selected = k[1], settings.also = {k[3], k[2]};
  remove_knot(d, k[3]);
  drop_dead(d, settings);
  EXPECT_EQ(selected_knots(d, settings), (std::vector<Entity>{k[2], k[1]}));
  remove_knot(d, k[1]);
  drop_dead(d, settings);
  EXPECT_EQ(settings.selected, k[2]);
  EXPECT_TRUE(settings.also.empty());
  remove_knot(d, k[2]);
  drop_dead(d, settings);
  EXPECT_FALSE(settings.selected.valid());
}

}  // namespace selection_test
}  // namespace coaster::world
