// The values of all queries as JSON: src/query/query.
#include "query/query.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "edit/commands/commands_document.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "query/context.h"

namespace coaster::query {
namespace all_values_test {

// Returns how often a name occurs, alone or with an argument.
std::ptrdiff_t count_of(const exchange::JsonMembers& members, const std::string& name) {
  return std::count_if(members.begin(), members.end(),
                       [&](const auto& member) { return member.name == name || member.name.starts_with(name + " "); });
}

TEST(all_values, each_query_is_there_once_or_once_for_each_knot) {
  edit::Session session = edit::make_session({});
  base::Files files;
  for (const glm::vec3 at : {glm::vec3(-3.25f, 1.5f, 2.75f), glm::vec3(9.5f, 4.25f, -1.125f)})
    ASSERT_TRUE(edit::apply(session, files, edit::AppendKnot{at}));
  FrameStats stats;
  const exchange::JsonMembers members = all_values({session, stats, "", "title"});
  for (const Query& query : queries())
    if (query.argument.empty()) {
      EXPECT_EQ(count_of(members, std::string(query.name)), 1) << query.name;
    }
  EXPECT_EQ(count_of(members, "position"), 2);
  EXPECT_EQ(count_of(members, "hash"), 2) << "of document and motion";
  const std::string text = exchange::json_members(members);
  EXPECT_NE(text.find("\"knots\": 2"), std::string::npos) << text.substr(0, 400);
  EXPECT_NE(text.find("\"ride.lap_time\": null"), std::string::npos);
}

}  // namespace all_values_test
}  // namespace coaster::query
