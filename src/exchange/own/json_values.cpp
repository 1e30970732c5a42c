#include "exchange/own/json_values.h"

#include "exchange/own/json_text.h"

namespace coaster::exchange {

namespace {

Json tree_of(const JsonMembers& members);
Json tree_of(const JsonList& list) {
  Json tree = Json::array();
  for (const JsonMembers& members : list) tree.push_back(tree_of(members));
  return tree;
}
template <class T>
Json tree_of(const T& value) {
  return Json(value);
}
Json tree_of(const JsonMembers& members) {
  Json tree = Json::object();
  for (const auto& [name, value] : members) tree[name] = std::visit([](const auto& v) { return tree_of(v); }, value);
  return tree;
}

}  // namespace

std::string json_members(const JsonMembers& members) { return json_file(tree_of(members)); }

}  // namespace coaster::exchange
