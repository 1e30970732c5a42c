#include "world/document_difference.h"

#include <gtest/gtest.h>

#include "world/sample_documents.h"
#include "world/topology.h"

namespace coaster::world {
namespace document_difference_test {

// Edits of every kind that change entities, their order, their components or the rest of the document.
std::vector<Document> versions() {
  std::vector<Document> all{test::sample_document()};
  const auto then = [&](auto change) {
    Document next = all.back();
    change(next);
    all.push_back(std::move(next));
  };
  then([](Document& d) { d.entities.get<Knot>(d.track.knots[2]).position.y = -0.0f; });
  then([](Document& d) { d.entities.get<Knot>(d.track.knots[2]).position.y = 0.0f; });
  then([](Document& d) { split_segment(d, d.track.segments[1], 0.3, {0, 1, 0}, 0); });
  then([](Document& d) { remove_knot(d, d.track.knots[1]); });
  then([](Document& d) { d.entities.put(d.track.segments[0], Equipment{}); });
  then([](Document& d) {
    d.entities.put(d.track.knots[0], UnknownMembers{"{\"a\": 1}"}), d.name = "Other", d.datum = 3;
  });
  then([](Document& d) { reverse(d); });
  then([](Document& d) { add_cart(d, d.track.segments[1], 0.2); });
  then([](Document& d) { set_closed(d, !d.track.closed); });
  then([](Document& d) { d = Document{}; });
  return all;
}

// The slots that the next entities will get are the same, too.
void expect_same(Document a, Document b) {
  EXPECT_TRUE(a == b);
  EXPECT_EQ(hash(a), hash(b));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(a.entities.create(), b.entities.create());
  EXPECT_EQ(a.entities.pool<Knot>().entities(), b.entities.pool<Knot>().entities());
}

TEST(difference, leads_from_any_version_to_any_other_and_back) {
  const std::vector<Document> all = versions();
  for (const Document& from : all)
    for (const Document& to : all) {
      DocumentDifference difference = difference_of(from, to);
      Document document = to;
      exchange(difference, document);
      expect_same(document, from);
      exchange(difference, document);
      expect_same(document, to);
    }
}

TEST(difference, of_equal_documents_is_as_small_as_an_empty_one) {
  const Document d = test::sample_document();
  DocumentDifference none = difference_of(d, d);
  EXPECT_LE(bytes_of(none), sizeof(DocumentDifference) + 64 + d.name.size() + d.extra.json.size());
}

}  // namespace document_difference_test
}  // namespace coaster::world
