#include "exchange/export/shape_export.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "exchange/export/shape_readers.h"

namespace coaster::exchange {
namespace shape_export_test {

using test::Gltf;
using test::Obj;

TEST(Shapes, tracks_without_segments_give_valid_files) {
  world::Document d;
  for (int knots = 0; knots < 2; ++knots) {
    const Gltf gltf(print_gltf(d));
    EXPECT_FALSE(gltf.file.contains("buffers"));
    EXPECT_FALSE(gltf.file["scenes"].at(0).contains("nodes"));
    const Obj obj = test::read_obj(print_obj(d));
    EXPECT_TRUE(obj.v.empty() && obj.faces.empty() && obj.line.empty());
    EXPECT_EQ(print_svg(d).find("nan"), std::string::npos);
    world::append_knot(d, {});
  }
}

TEST(Shapes, random_tracks_have_finite_numbers_alone) {
  for (int seed = 0; seed < test::tries(4); ++seed) {
    world::Document d = test::random_document(static_cast<std::uint32_t>(seed));
    for (const world::Entity e : d.track.knots)
      d.entities.get<world::Knot>(e).position *= 0.1f;  // files of less than megabytes
    const Gltf gltf(print_gltf(d));
    for (const Json& mesh : gltf.file.value("meshes", Json::array()))
      for (const Json& primitive : mesh["primitives"])
        EXPECT_TRUE(
            std::ranges::all_of(gltf.positions(primitive), [](glm::vec3 p) { return std::isfinite(p.x + p.y + p.z); }));
    for (const std::string& text : {print_obj(d), print_svg(d)}) EXPECT_EQ(text.find("inf"), std::string::npos);
  }
}

}  // namespace shape_export_test
}  // namespace coaster::exchange
