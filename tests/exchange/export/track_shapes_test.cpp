#include "exchange/export/track_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "exchange/own/json_reader.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace track_shapes_test {

world::Document closed_document() {
  world::Document d = test::sample_document();
  world::set_closed(d, true);
  return d;
}

// How far a point is from the track's exact curve.
double off_track(const world::Document& d, glm::vec3 p) {
  double least = 1e9;
  for (const world::Entity s : d.track.segments)
    least = std::min(least, curve::nearest_point(world::cubic_of(d, s), glm::dvec3(p)).distance);
  return least;
}

// Six times the volume that triangles enclose; positive when they face outwards.
double volume(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
  double sum = 0;
  const glm::dvec3 origin(positions.at(0));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 a(positions.at(indices[i])), b(positions.at(indices[i + 1])), c(positions.at(indices[i + 2]));
    sum += glm::dot(a - origin, glm::cross(b - origin, c - origin));
  }
  return sum / 6;
}

struct Obj {
  std::vector<glm::vec3> v, vn;
  std::map<std::string, std::vector<std::uint32_t>> faces;
  std::vector<std::uint32_t> line;
};

Obj read_obj(const std::string& text) {
  Obj obj;
  std::istringstream lines(text);
  std::string line, group;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "g") words >> group;
    if (word == "v" || word == "vn") {
      glm::vec3 p;
      EXPECT_TRUE(words >> p.x >> p.y >> p.z) << line;
      (word == "v" ? obj.v : obj.vn).push_back(p);
    }
    if (word == "f")
      for (int k = 0; k < 3; ++k) {
        std::uint32_t a = 0, b = 0;
        char slash;
        EXPECT_TRUE(words >> a >> slash >> slash >> b) << line;
        EXPECT_EQ(a, b);
        obj.faces[group].push_back(a - 1);
      }
    if (word == "l")
      for (std::uint32_t a = 0; words >> a;) obj.line.push_back(a - 1);
  }
  return obj;
}

// Of two rails and a spine, at one end: a fan over n corners has n - 2 triangles.
constexpr std::size_t kCapTriangles = 2 * (sim::kRailSides - 2) + sim::kSpineSides - 2;

// The triangles of a tube's cap are the flat faces across the track: counts those at each place of a segment's end.
// Corners of sides lie in two rings.
std::size_t caps_of(const Obj& obj, const char* group, const world::Document& d) {
  std::size_t caps = 0;
  const std::vector<std::uint32_t>& faces = obj.faces.at(group);
  for (const world::Entity e : d.track.knots) {
    const world::Knot& knot = world::knot(d, e);
    for (std::size_t i = 0; i < faces.size(); i += 3) {
      bool across = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 off = glm::dvec3(obj.v.at(faces[i + k])) - glm::dvec3(knot.position);
        across = across && glm::length(off) < 1.2 && std::abs(glm::dot(off, glm::dvec3(knot.tangent))) < 1e-4;
      }
      caps += across;
    }
  }
  return caps;
}

// Edges that lie not in two triangles, once each way. Corners are the same where their positions are, bit for bit.
std::size_t open_edges(const Obj& obj, const char* group) {
  using Point = std::array<float, 3>;
  std::map<std::pair<Point, Point>, int> ways;
  const std::vector<std::uint32_t>& faces = obj.faces.at(group);
  const auto point = [&](std::size_t i) {
    const glm::vec3 p = obj.v.at(faces[i]);
    return Point{p.x, p.y, p.z};
  };
  for (std::size_t i = 0; i < faces.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++ways[{point(i + k), point(i + (k + 1) % 3)}];
  return static_cast<std::size_t>(std::ranges::count_if(ways, [&](const auto& way) {
    const auto back = ways.find({way.first.second, way.first.first});
    return way.second != 1 || back == ways.end() || back->second != 1;
  }));
}

TEST(Obj, tubes_have_caps_at_the_ends_of_open_track_alone_and_every_edge_twice) {
  for (const world::Document& d : {test::sample_document(), closed_document()}) {
    const Obj obj = read_obj(print_obj(d));
    const std::size_t ends = d.track.closed ? 0 : 2;
    EXPECT_EQ(caps_of(obj, "rails", d), 2 * ends * (sim::kRailSides - 2));
    EXPECT_EQ(caps_of(obj, "spine", d), ends * (sim::kSpineSides - 2));
    EXPECT_EQ(open_edges(obj, "rails"), 0u);
    EXPECT_EQ(open_edges(obj, "spine"), 0u);
  }
}

TEST(Obj, has_the_swept_track_and_the_centre_line) {
  for (const world::Document& d : {test::sample_document(), closed_document()}) {
    const Obj obj = read_obj(print_obj(d));
    sim::Derived derived;
    sim::derive(d, {}, {}, derived);
    std::size_t triangles = 0, vertices = 0;
    sim::Mesh mesh;
    for (const world::Entity s : d.track.segments) {
      sim::sweep_track(derived.shape(s), mesh);
      triangles += mesh.indices.size(), vertices += mesh.vertices.size();
    }
    triangles -= 3 * kCapTriangles * 2 * (d.track.segments.size() - (d.track.closed ? 0 : 1));
    sim::Supports supports;
    supports.update(derived);
    for (const world::Entity s : d.track.segments) {
      sim::build_support_mesh(*supports.of(s), mesh);
      triangles += mesh.indices.size(), vertices += mesh.vertices.size();
    }
    const auto size_of = [&](const char* group) {
      return obj.faces.count(group) != 0 ? obj.faces.at(group).size() : 0;
    };
    EXPECT_EQ(size_of("rails") + size_of("spine") + size_of("ties") + size_of("supports") + size_of("concrete"),
              triangles);
    for (const char* group : {"supports", "concrete"}) EXPECT_GT(volume(obj.v, obj.faces.at(group)), 0);
    EXPECT_GT(supports.count(), 0);
    EXPECT_EQ(size_of("equipment"), 0u);
    EXPECT_EQ(obj.vn.size(), vertices);
    EXPECT_EQ(obj.v.size(), vertices + obj.line.size());
    for (const glm::vec3 n : obj.vn) ASSERT_NEAR(glm::length(n), 1, 1e-5);
    // Two tubes of octagons along the track; the bends make their lengths differ from the curve's a little.
    const double octagon = 2 * std::sqrt(2.0), length = derived.length;
    EXPECT_NEAR(volume(obj.v, obj.faces.at("rails")), 2 * octagon * sim::kRailRadius * sim::kRailRadius * length,
                0.03 * length * sim::kRailRadius);
    EXPECT_GT(volume(obj.v, obj.faces.at("spine")), 0);
    EXPECT_GT(volume(obj.v, obj.faces.at("ties")), 0);
    ASSERT_GT(obj.line.size(), 10u);
    const glm::vec3 first = obj.v.at(obj.line.front()), last = obj.v.at(obj.line.back());
    EXPECT_EQ(first, world::knot(d, d.track.knots.front()).position);
    EXPECT_EQ(last, world::knot(d, d.track.closed ? d.track.knots.front() : d.track.knots.back()).position);
    for (std::size_t i = 0; i + 1 < obj.line.size(); ++i) {
      const glm::vec3 a = obj.v.at(obj.line[i]), b = obj.v.at(obj.line[i + 1]);
      ASSERT_LT(off_track(d, a), 2e-5);
      ASSERT_LT(off_track(d, 0.5f * (a + b)), 0.00103);
    }
  }
}

std::string unbase64(const std::string& text) {
  const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i) values[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
  std::string bytes;
  bytes.reserve(text.size());
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const int digit = values[static_cast<unsigned char>(c)];
    if (digit < 0) ADD_FAILURE() << "no digit of base64: " << c;
    group = group << 6 | static_cast<std::uint32_t>(digit), bits += 6;
    if (bits >= 8) bits -= 8, bytes += static_cast<char>(group >> bits & 0xff);
  }
  return bytes;
}

// A file taken apart by the specification's rules.
struct Gltf {
  Json file;
  std::string buffer;

  // The bytes are cut out before the rest is read as JSON, which takes its time with a text of megabytes.
  explicit Gltf(const std::string& text) {
    const std::string head = "data:application/octet-stream;base64,";
    const std::size_t at = text.find(head), from = at == std::string::npos ? text.size() : at + head.size(),
                      to = std::min(text.find('"', from), text.size());
    base::Result<Json> tree = read_json(text.substr(0, from) + text.substr(to), "glTF");
    if (!tree) throw std::runtime_error(tree.status().message);
    file = std::move(*tree);
    if (!file.contains("buffers")) return;
    EXPECT_EQ(file["buffers"][0]["uri"].get<std::string>(), head);
    buffer = unbase64(text.substr(from, to - from));
    EXPECT_EQ(buffer.size(), file["buffers"][0]["byteLength"].get<std::size_t>());
  }
  template <class T>
  std::vector<T> items(std::size_t accessor, const std::string& type, int component) const {
    const Json& a = file["accessors"].at(accessor);
    const Json& view = file["bufferViews"].at(a["bufferView"].get<std::size_t>());
    EXPECT_EQ(a["type"].get<std::string>(), type);
    EXPECT_EQ(a["componentType"].get<int>(), component);
    const std::size_t count = a["count"], offset = view["byteOffset"], length = view["byteLength"];
    EXPECT_GT(count, 0u);
    EXPECT_EQ(offset % 4, 0u);
    EXPECT_EQ(length, count * sizeof(T));
    EXPECT_LE(offset + length, buffer.size());
    std::vector<T> out(count);
    std::memcpy(out.data(), buffer.data() + offset, length);
    return out;
  }
  std::vector<glm::vec3> positions(const Json& primitive) const {
    const std::size_t accessor = primitive["attributes"]["POSITION"];
    const auto out = items<glm::vec3>(accessor, "VEC3", 5126);
    for (int axis = 0; axis < 3; ++axis) {
      float low = out[0][axis], high = low;
      for (const glm::vec3 p : out) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
      EXPECT_EQ(file["accessors"][accessor]["min"].at(axis).get<float>(), low);
      EXPECT_EQ(file["accessors"][accessor]["max"].at(axis).get<float>(), high);
    }
    return out;
  }
};

TEST(Gltf, keeps_the_rules_of_the_format_and_has_the_same_triangles_as_the_obj) {
  world::Document d = closed_document();
  d.entities.put(d.track.segments[1], world::Equipment{world::EquipmentKind::brake, 8.0f, 2.0f, 0.5f, 5});
  const Gltf gltf(print_gltf(d));
  const Obj obj = read_obj(print_obj(d));
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
  const Json& strip = gltf.file["meshes"].at(1)["primitives"].at(0);
  EXPECT_EQ(strip["mode"].get<int>(), 3);
  const auto line = gltf.positions(strip);
  ASSERT_EQ(line.size(), obj.line.size());
  for (std::size_t i = 0; i < line.size(); ++i) ASSERT_EQ(line[i], obj.v.at(obj.line[i]));
  std::size_t used = 0;
  for (const Json& view : gltf.file["bufferViews"]) used += view["byteLength"].get<std::size_t>();
  EXPECT_EQ(used, gltf.buffer.size());
}

// The numbers of the attribute or path data that follow `key` behind `from`.
std::vector<double> numbers_after(const std::string& text, const std::string& key, std::size_t from) {
  const std::size_t start = text.find(key, from) + key.size();
  std::string part = text.substr(start, text.find_first_of("\")", start) - start);
  for (char& c : part)
    if (std::isalpha(static_cast<unsigned char>(c)) && c != 'e') c = ' ';
  std::istringstream words(part);
  std::vector<double> out;
  for (double number = 0; words >> number;) out.push_back(number);
  return out;
}

TEST(Svg, draws_the_cubics_themselves_within_the_sheet) {
  const world::Document d = closed_document();
  const std::string text = print_svg(d);
  const auto sheet = numbers_after(text, "viewBox=\"", 0);
  ASSERT_EQ(sheet.size(), 4u);
  for (const auto& [id, row, sign] : {std::tuple{"plan", 2, 1.0f}, {"elevation", 1, -1.0f}}) {
    const std::size_t group = text.find(std::string("<g id=\"") + id + "\"");
    ASSERT_NE(group, std::string::npos);
    const auto moved = numbers_after(text, "translate(", group), path = numbers_after(text, "<path d=\"", group);
    ASSERT_EQ(moved.size(), 2u);
    std::vector<glm::vec3> wanted{world::cubic_of(d, d.track.segments[0]).p0};
    for (const world::Entity s : d.track.segments) {
      const curve::Cubic c = world::cubic_of(d, s);
      wanted.insert(wanted.end(), {c.p1, c.p2, c.p3});
    }
    ASSERT_EQ(path.size(), 2 * wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(static_cast<float>(path[2 * i]), wanted[i].x);
      EXPECT_EQ(static_cast<float>(path[2 * i + 1]), sign * wanted[i][row]);
      EXPECT_GT(path[2 * i] + moved[0], 0);
      EXPECT_LT(path[2 * i] + moved[0], sheet[2]);
      EXPECT_GT(path[2 * i + 1] + moved[1], 0);
      EXPECT_LT(path[2 * i + 1] + moved[1], sheet[3]);
    }
    // The bar is as long as the text beside it says: the length stands behind the last blank before " m<".
    const std::size_t bar = text.find(std::string("<path id=\"") + id + "-bar\"");
    const auto numbers = numbers_after(text, " d=\"", bar);
    const std::size_t end = text.find(" m</text>", bar), start = text.rfind('>', end) + 1;
    ASSERT_EQ(numbers.size(), 3u);
    EXPECT_EQ(std::stod(text.substr(start, end - start)), numbers[2]);
    EXPECT_GT(numbers[2], 1);
  }
}

TEST(Svg, names_cannot_break_the_file) {
  world::Document d;
  d.name = "<b>&\n";
  EXPECT_NE(print_svg(d).find("<title>&lt;b&gt;&amp; </title>"), std::string::npos);
}

TEST(Shapes, tracks_without_segments_give_valid_files) {
  world::Document d;
  for (int knots = 0; knots < 2; ++knots) {
    const Gltf gltf(print_gltf(d));
    EXPECT_FALSE(gltf.file.contains("buffers"));
    EXPECT_FALSE(gltf.file["scenes"].at(0).contains("nodes"));
    const Obj obj = read_obj(print_obj(d));
    EXPECT_TRUE(obj.v.empty() && obj.faces.empty() && obj.line.empty());
    EXPECT_EQ(print_svg(d).find("nan"), std::string::npos);
    world::append_knot(d, {});
  }
}

TEST(Shapes, random_tracks_have_finite_numbers_alone) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const world::Document d = test::random_document(seed);
    const Gltf gltf(print_gltf(d));
    for (const Json& mesh : gltf.file.value("meshes", Json::array()))
      for (const Json& primitive : mesh["primitives"])
        EXPECT_TRUE(
            std::ranges::all_of(gltf.positions(primitive), [](glm::vec3 p) { return std::isfinite(p.x + p.y + p.z); }));
    for (const std::string& text : {print_obj(d), print_svg(d)}) EXPECT_EQ(text.find("inf"), std::string::npos);
  }
}

}  // namespace track_shapes_test
}  // namespace coaster::exchange
