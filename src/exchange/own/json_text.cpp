#include "exchange/own/json_text.h"

namespace coaster::exchange {
namespace {

std::string dump(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string json_file(const Json& tree, int indent) { return dump(tree, indent) + "\n"; }
std::string json_line(const Json& value) { return dump(value, -1); }
std::string json_string(std::string_view text) { return json_line(Json(std::string(text))); }

}  // namespace coaster::exchange
