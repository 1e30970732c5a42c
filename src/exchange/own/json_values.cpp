#include "exchange/own/json_values.h"

#include "exchange/own/json_text.h"

namespace coaster::exchange {

std::string json_members(const JsonMembers& members) {
  Json tree = Json::object();
  for (const auto& [name, value] : members) tree[name] = std::visit([](const auto& v) { return Json(v); }, value);
  return json_file(tree);
}

}  // namespace coaster::exchange
