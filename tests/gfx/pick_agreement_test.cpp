// Picked items are the visible ones: pick() against an id picture of its rules, and against the renderer's picture with
// the overlay's marks repainted.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "gfx/id_picture.h"
#include "gfx/renderer.h"
#include "platform/surface.h"

namespace coaster::gfx {
namespace pick_agreement_test {

using test::Id;
using test::kNothing;
using test::LevelView;
using view::PickKind;

// Counts how pick() and a picture agree at pixels. At edges, where the sample of a pixel and the rasteriser may round
// apart, a neighbour's id will do.
struct Agreement {
  int same = 0, at_edges = 0, not_shown = 0;
  std::map<PickKind, int> by_kind;

  // `id_at` gives the id in the picture, nothing where the picture does not say.
  void compare(const LevelView& sight, const std::function<std::optional<Id>(int, int)>& id_at, int column, int row) {
    const view::Viewport& v = sight.view.viewport;
    const view::Pick pick = sight.at({v.x + static_cast<float>(column) + 0.5f, v.y + static_cast<float>(row) + 0.5f});
    const Id expected = test::id_of(pick.kind, pick.entity);
    const std::optional<Id> seen = id_at(column, row);
    ++by_kind[pick.kind];
    if (!seen) {
      ++not_shown;
      return;
    }
    if (*seen == expected) {
      ++same;
      return;
    }
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, test::kIdHeight - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, test::kIdWidth - 1); ++x)
        if (id_at(x, y) == expected) {
          ++at_edges;
          return;
        }
    const glm::vec3 eye = sight.view.eye;
    ADD_FAILURE() << "at " << column << ", " << row << " from " << eye.x << " " << eye.y << " " << eye.z
                  << " the picture has kind " << int((*seen)[1]) << " of slot " << int((*seen)[0]) - 1
                  << ", picked is kind " << int(expected[1]) << " of slot " << int(expected[0]) - 1;
  }
  int compared() const { return same + at_edges + not_shown; }
};

// Pixels where marks and carts have their middles, as far as they are in the picture, then random ones.
std::vector<glm::ivec2> places(const LevelView& sight, std::mt19937& bits, int random_ones) {
  std::vector<glm::ivec2> out;
  const auto add = [&](glm::vec3 position) {
    const auto pixel = view::project(sight.view, position);
    if (!pixel || !sight.view.viewport.contains(glm::vec2(*pixel))) return;
    out.emplace_back(int(pixel->x - sight.view.viewport.x), int(pixel->y - sight.view.viewport.y));
  };
  for (const world::Entity e : sight.document.track.knots) {
    const world::Knot& knot = world::knot(sight.document, e);
    for (const glm::vec3 p : {knot.position, world::in_handle(knot), world::out_handle(knot)}) add(p);
  }
  for (const sim::Pose& pose : sight.carts()) add(glm::vec3(pose.position + 0.5 * pose.frame.up));
  for (int i = 0; i < random_ones; ++i) {
    const auto at = bits() % (test::kIdWidth * test::kIdHeight);
    out.emplace_back(at % test::kIdWidth, at / test::kIdWidth);
  }
  return out;
}

struct PickAgreement : testing::Test {
  void SetUp() override {
    auto made = platform::make_offscreen({});
    ASSERT_TRUE(made.ok()) << made.status().message;
    surface = std::move(*made);
    auto loaded = load_gl([this](const char* name) { return surface->gl_proc(name); });
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    gl = *loaded;
  }
  std::unique_ptr<platform::Surface> surface;
  Gl gl;
};

TEST_F(PickAgreement, a_thousand_views_are_picked_as_an_id_picture_shows_them) {
  LevelView sight = test::make_sight();
  test::IdPicture picture(gl);
  std::mt19937 bits(20250917);
  Agreement agreement;
  for (int views = 0; views < 1000 && !HasFailure();) {
    test::look_around(bits, sight);
    if (test::near_a_cart(sight)) continue;
    ++views;
    picture.draw(sight);
    for (const glm::ivec2 p : places(sight, bits, 20))
      agreement.compare(
          sight, [&](int column, int row) { return std::optional(picture.at(column, row)); }, p.x, p.y);
  }
  EXPECT_EQ(gl.GetError(), GLenum(GL_NO_ERROR));
  EXPECT_LT(agreement.at_edges, agreement.compared() / 100);
  for (const PickKind kind :
       {PickKind::none, PickKind::knot, PickKind::handle_in, PickKind::handle_out, PickKind::cart, PickKind::curve})
    EXPECT_GT(agreement.by_kind[kind], 100) << "too few of kind " << int(kind) << " to prove anything";
}

// Magenta with the id in green appears nowhere in a scene, which has no pure colours. Rims of marks and antialiased
// edges have no id.
std::uint32_t paint_of(std::size_t index) { return 0xff00ffffu | static_cast<std::uint32_t>(index + 1) << 16; }

TEST_F(PickAgreement, the_renderer_shows_at_each_mark_the_mark_that_is_picked_there) {
  LevelView sight = test::make_sight();
  Renderer renderer(gl, 0);
  std::mt19937 bits(40961);
  Agreement agreement;
  for (int i = 0; i < 200 && !HasFailure(); ++i) {
    test::look_around(bits, sight);
    sight.view.viewport.x = sight.view.viewport.y = 0;
    view::Overlay overlay = view::build_overlay(sight.document, sight.derived, sight.settings, sight.view, {});
    std::vector<Id> ids{kNothing};  // by green
    for (std::size_t k = 0; k < overlay.marks.size(); ++k) {
      Id id = kNothing;  // of the place on the curve, which is no mark to be picked
      for (const world::Entity e : sight.document.track.knots) {
        const world::Knot& knot = world::knot(sight.document, e);
        const bool square = overlay.marks[k].shape == view::MarkShape::square;
        if (!square && overlay.marks[k].position == knot.position) id = test::id_of(PickKind::knot, e);
        if (square && overlay.marks[k].position == world::in_handle(knot)) id = test::id_of(PickKind::handle_in, e);
        if (square && overlay.marks[k].position == world::out_handle(knot)) id = test::id_of(PickKind::handle_out, e);
      }
      ids.push_back(id);
      overlay.marks[k].rgba = paint_of(k);
    }
    const std::vector<sim::Pose> carts = sight.carts();
    renderer.draw({sight.derived, sight.view, overlay, carts, false}, test::kIdWidth, test::kIdHeight);
    const Image image = renderer.read_pixels();
    const auto id_at = [&](int column, int row) -> std::optional<Id> {
      const std::uint8_t* const p = &image.rgba[4 * (std::size_t(row) * test::kIdWidth + std::size_t(column))];
      if (p[0] != 255 || p[2] != 255 || p[1] >= ids.size()) return std::nullopt;
      return ids[p[1]];
    };
    for (const glm::ivec2 p : places(sight, bits, 0)) {
      const PickKind kind = sight.at(glm::vec2(p) + 0.5f).kind;
      if (kind == PickKind::knot || kind == PickKind::handle_in || kind == PickKind::handle_out)
        agreement.compare(sight, id_at, p.x, p.y);
    }
  }
  EXPECT_GT(agreement.by_kind[PickKind::knot], 500);
  EXPECT_GT(agreement.by_kind[PickKind::handle_in], 50);
  // A quarter of the middles are under the rim of a nearer mark.
  EXPECT_LT(agreement.not_shown, agreement.compared() / 3);
  EXPECT_LT(agreement.at_edges, agreement.compared() / 20);
}

}  // namespace pick_agreement_test
}  // namespace coaster::gfx
