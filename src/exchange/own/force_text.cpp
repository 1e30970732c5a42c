#include "exchange/own/force_text.h"

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::exchange {
namespace {

constexpr std::size_t kFew = 2, kAll = 5;  // numbers in a key, at least and at most

std::string number_text(double value) { return value == 0 ? "0" : base::to_text(value); }  // never "-0"

std::string key_text(const world::ForceKey& key) {
  const bool shaped = key.slope != 0 || key.before != 0 || key.after != 0;
  std::string text = fmt::format("[{}, {}", number_text(key.at), number_text(key.value));
  if (shaped)
    text += fmt::format(", {}, {}, {}", number_text(key.slope), number_text(key.before), number_text(key.after));
  return text + "]";
}

bool read_key(Fields& fields, std::string_view channel, std::size_t index, const Json& value, world::ForceKey& key) {
  const auto wrong = [&] {
    return fields.fail(fmt::format("{}[{}]", channel, index),
                       fmt::format("expected {} or {} numbers, found {}", kFew, kAll, describe(value)));
  };
  if (!value.is_array() || (value.size() != kFew && value.size() != kAll)) return wrong();
  double* const members[] = {&key.at, &key.value, &key.slope, &key.before, &key.after};
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_number()) return wrong();
    *members[i] = value[i].get<double>();
    if (*members[i] == 0) *members[i] = 0;  // not -0, which is printed as 0
  }
  return true;
}

std::string list_text(const std::vector<world::ForceKey>& keys) {
  std::string text = "[";
  for (const world::ForceKey& key : keys) text += (text.size() == 1 ? "" : ", ") + key_text(key);
  return text + "]";
}

bool read_list(Fields& fields, std::string_view member, std::vector<world::ForceKey>& keys) {
  const Json* const list = fields.list(member, world::kMostForceKeys);
  if (!list) return false;
  keys.resize(list->size());
  for (std::size_t i = 0; i < list->size(); ++i)
    if (!read_key(fields, member, i, (*list)[i], keys[i])) return false;
  return true;
}

template <class Named>
bool read_named(Fields& fields, std::string_view member, Named& value) {
  std::string name;
  if (!fields.text(member, name)) return false;
  const auto named = base::value_named<Named>(name);
  if (named) value = *named;
  return named || fields.reject(member, base::alternatives_of<Named>("\""));
}

constexpr std::string_view kCopied = "force-keys", kOf = "of", kKeys = "keys";

}  // namespace

std::string print_keys(const CopiedKeys& copied) {
  const std::string of =
      copied.of == world::ForceOf::forces ? "" : fmt::format("\"{}\": \"{}\", ", kOf, base::name_of(copied.of));
  return fmt::format("{{\"{}\": \"{}\", {}\"{}\": {}}}", kCopied, base::name_of(copied.over), of, kKeys,
                     list_text(copied.keys));
}

base::Result<CopiedKeys> parse_keys(std::string_view text) {
  const auto json = read_json(text, "clipboard");
  if (!json) return json.status();
  std::string error;
  Fields fields(*json, {}, error);
  CopiedKeys copied;
  if (!read_named(fields, kCopied, copied.over) || (fields.has(kOf) && !read_named(fields, kOf, copied.of)) ||
      !read_list(fields, kKeys, copied.keys))
    return bad_file("clipboard", error);
  world::ForceProgram program;  // for its limits
  program.over = copied.over, program.of = copied.of, program.length = world::longest_of(copied.over);
  program.keys(world::ForceChannel::roll) = copied.keys;
  if (copied.keys.empty()) return bad_file("clipboard", "no keys");
  if (const auto wrong = world::broken(program)) return bad_file("clipboard", *wrong);
  return copied;
}

std::string force_keys(const world::ForceProgram& force) {
  std::string text;
  for (std::size_t c = 0; c < force.channels.size(); ++c) {
    if (force.channels[c].empty()) continue;
    text +=
        fmt::format(", \"{}\": {}", base::name_of(static_cast<world::ForceChannel>(c)), list_text(force.channels[c]));
  }
  return text;
}

bool read_force_keys(Fields& fields, world::ForceProgram& force) {
  for (std::size_t c = 0; c < force.channels.size(); ++c) {
    const std::string_view name = base::name_of(static_cast<world::ForceChannel>(c));
    if (fields.has(name) && !read_list(fields, name, force.channels[c])) return false;
  }
  const auto wrong = world::broken(force);
  return !wrong || fields.fail({}, *wrong);
}

}  // namespace coaster::exchange
