// Reads the exported files, by the rules of the formats.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "exchange/own/json.h"
#include "world/sample_documents.h"

namespace coaster::test {

inline world::Document closed_document() {
  world::Document d = sample_document();
  world::set_closed(d, true);
  return d;
}

struct Obj {
  std::vector<glm::vec3> v, vn, vc;  // vc: colours of those vertices that have one
  std::map<std::string, std::vector<std::uint32_t>> faces;
  std::vector<std::uint32_t> line;
};

inline Obj read_obj(const std::string& text) {
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
      if (word == "v" && words >> p.x >> p.y >> p.z) obj.vc.push_back(p);
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

inline std::string unbase64(const std::string& text) {
  const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i) values[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
  std::string bytes;
  bytes.reserve(text.size());
  std::uint32_t group = 0;
  int bits = 0;
  const std::size_t end = std::min(text.find('='), text.size());
  EXPECT_EQ(text.size() % 4, 0u) << "groups of four";
  EXPECT_LT(text.size() - end, 3u) << "the fewest '=' that fill the last group";
  for (const char c : text.substr(0, end)) {
    const int digit = values[static_cast<unsigned char>(c)];
    if (digit < 0) ADD_FAILURE() << "no digit of base64: " << c;
    group = group << 6 | static_cast<std::uint32_t>(digit), bits += 6;
    if (bits >= 8) bits -= 8, bytes += static_cast<char>(group >> bits & 0xff);
  }
  EXPECT_EQ(group & ((1u << bits) - 1), 0u) << "no bits are left over";
  return bytes;
}

// A file parsed by the specification's rules.
struct Gltf {
  exchange::Json file;
  std::string buffer;

  // The bytes are removed before the rest is parsed as JSON, which is slow for megabytes of text.
  explicit Gltf(const std::string& text) {
    const std::string head = "data:application/octet-stream;base64,";
    const std::size_t at = text.find(head), from = at == std::string::npos ? text.size() : at + head.size(),
                      to = std::min(text.find('"', from), text.size());
    base::Result<exchange::Json> tree = exchange::read_json(text.substr(0, from) + text.substr(to), "glTF");
    if (!tree) throw std::runtime_error(tree.status().message);
    file = std::move(*tree);
    if (!file.contains("buffers")) return;
    EXPECT_EQ(file["buffers"][0]["uri"].get<std::string>(), head);
    buffer = unbase64(text.substr(from, to - from));
    EXPECT_EQ(buffer.size(), file["buffers"][0]["byteLength"].get<std::size_t>());
  }
  template <class T>
  std::vector<T> items(std::size_t accessor, const std::string& type, int component) const {
    const exchange::Json& a = file["accessors"].at(accessor);
    const exchange::Json& view = file["bufferViews"].at(a["bufferView"].get<std::size_t>());
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
  std::vector<glm::vec3> positions(const exchange::Json& primitive) const {
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
  // The index of the only element of a list with this name.
  std::size_t named(const char* list, const std::string& name) const {
    std::size_t found = 0, count = 0, i = 0;
    for (const exchange::Json& element : file[list]) {
      if (element.value("name", "") == name) found = i, ++count;
      ++i;
    }
    EXPECT_EQ(count, 1u) << list << ' ' << name;
    return found;
  }
  // The primitive of a mesh with this material.
  const exchange::Json& primitive(const std::string& mesh, const std::string& of) const {
    const std::size_t wanted = named("materials", of);
    for (const exchange::Json& primitive : file["meshes"].at(named("meshes", mesh))["primitives"])
      if (primitive["material"].get<std::size_t>() == wanted) return primitive;
    throw std::runtime_error("no primitive of " + of);
  }
};

}  // namespace coaster::test
