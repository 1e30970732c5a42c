// glTF 2.0.
#include <algorithm>

#include <gtest/gtest.h>

#include "exchange/export/shape_export.h"
#include "exchange/export/shape_readers.h"

namespace coaster::exchange {
namespace gltf_print_test {

using test::closed_document;
using test::Gltf;
using test::Obj;

TEST(Gltf, keeps_the_rules_of_the_format_and_has_the_same_triangles_as_the_obj) {
  world::Document d = closed_document();
  d.entities.put(d.track.segments[1], world::Equipment{world::EquipmentKind::brake, 8.0f, 2.0f, 0.5f, 5});
  const Gltf gltf(print_gltf(d));
  const Obj obj = test::read_obj(print_obj(d));
  EXPECT_EQ(gltf.file["asset"]["version"].get<std::string>(), "2.0");
  EXPECT_EQ(gltf.file["scenes"].at(gltf.file["scene"].get<std::size_t>())["nodes"].size(), 2u);
  for (const Json& node : gltf.file["nodes"]) EXPECT_LT(node["mesh"].get<std::size_t>(), gltf.file["meshes"].size());
  const Json& primitives = gltf.file["meshes"].at(0)["primitives"];
  const char* const names[]{"rails", "spine", "ties", "equipment", "supports", "concrete"};
  ASSERT_EQ(primitives.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Json& primitive = primitives[i];
    EXPECT_EQ(primitive["mode"].get<int>(), 4);
    EXPECT_EQ(gltf.file["materials"].at(primitive["material"].get<std::size_t>())["name"].get<std::string>(), names[i]);
    const auto positions = gltf.positions(primitive);
    const auto normals = gltf.items<glm::vec3>(primitive["attributes"]["NORMAL"], "VEC3", 5126);
    const auto indices = gltf.items<std::uint32_t>(primitive["indices"], "SCALAR", 5125);
    EXPECT_EQ(normals.size(), positions.size());
    ASSERT_EQ(indices.size(), obj.faces.at(names[i]).size());
    for (std::size_t k = 0; k < indices.size(); ++k) {
      ASSERT_LT(indices[k], positions.size());
      ASSERT_EQ(positions[indices[k]], obj.v.at(obj.faces.at(names[i])[k]));
      ASSERT_EQ(normals[indices[k]], obj.vn.at(obj.faces.at(names[i])[k]));
    }
  }
  // The ranges of the specification.
  ASSERT_EQ(gltf.file["materials"].size(), 7u) << "and one of the centre line";
  for (const Json& material : gltf.file["materials"]) {
    const Json& pbr = material["pbrMetallicRoughness"];
    ASSERT_EQ(pbr["baseColorFactor"].size(), 4u);
    for (const Json& part : pbr["baseColorFactor"]) EXPECT_TRUE(part.get<double>() >= 0 && part.get<double>() <= 1);
    EXPECT_EQ(pbr["baseColorFactor"].at(3).get<double>(), 1) << "opaque";
    for (const char* const name : {"metallicFactor", "roughnessFactor"})
      EXPECT_TRUE(pbr[name].get<double>() >= 0 && pbr[name].get<double>() <= 1);
  }
  const Json& strip = gltf.file["meshes"].at(1)["primitives"].at(0);
  EXPECT_EQ(strip["mode"].get<int>(), 3);
  const auto line = gltf.positions(strip);
  ASSERT_EQ(line.size(), obj.line.size());
  for (std::size_t i = 0; i < line.size(); ++i) ASSERT_EQ(line[i], obj.v.at(obj.line[i]));
  std::size_t used = 0;
  for (const Json& view : gltf.file["bufferViews"]) used += view["byteLength"].get<std::size_t>();
  EXPECT_EQ(used, gltf.buffer.size());
}

TEST(gltf_print, materials_that_no_part_uses_are_left_out) {
  const Json file = Gltf(print_gltf(test::closed_document())).file;
  std::vector<std::size_t> used;
  for (const Json& mesh : file["meshes"])
    for (const Json& primitive : mesh["primitives"]) used.push_back(primitive["material"].get<std::size_t>());
  std::sort(used.begin(), used.end());
  ASSERT_EQ(used.size(), file["materials"].size());
  for (std::size_t i = 0; i < used.size(); ++i) EXPECT_EQ(used[i], i);
  for (const Json& material : file["materials"]) EXPECT_NE(material["name"].get<std::string>(), "equipment");
}

}  // namespace gltf_print_test
}  // namespace coaster::exchange
