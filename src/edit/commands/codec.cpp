// Prints, parses and describes commands from their lists of fields. The values' text is in codec_values.cpp.
#include "edit/commands/codec.h"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "edit/commands/codec_values.h"
#include "edit/commands/command_list.h"
#include "exchange/own/share_link.h"

namespace coaster::edit {
namespace {

// "at?" is the keyword "at" of an optional field, "at?|by" one whose former name was "by". ":at" is a place on the
// segment before it, "@s3:0.5", which was written "@s3 at 0.5". A command that takes entities of any kind works only on
// segments, and help shows a segment.
struct Keyword {
  std::string word, former;
  bool optional = false, place = false;
  explicit Keyword(std::string_view text)
      : word(text.substr(0, text.find('|'))), optional(word.ends_with('?')), place(word.starts_with(':')) {
    if (const std::size_t bar = text.find('|'); bar != std::string_view::npos) former = text.substr(bar + 1);
    if (optional) word.pop_back();
    if (place) word.erase(0, 1);
  }
  bool is(std::string_view text) const { return text == word || (!former.empty() && text == former); }
};

// The operations of a field type, so that the rest is shared by all commands.
struct FieldType {
  std::string (*print)(const void* value);
  bool (*read)(base::WordReader& words, void* value);
  std::string (*usage)(const void* value);  // null: a target, whose words depend on the command
  std::string (*words)(const void* value, const world::Document& document);  // in words, for sentences
};
template <class T>
constexpr FieldType field_type() {
  FieldType type{};
  type.print = [](const void* value) { return print_value(*static_cast<const T*>(value)); };
  type.words = [](const void* value, const world::Document& document) {
    const T& typed = *static_cast<const T*>(value);
    if constexpr (requires { words_of(typed, document); }) return words_of(typed, document);
    else return words_of(typed);
  };
  type.read = [](base::WordReader& words, void* value) { return read_value(words, *static_cast<T*>(value)); };
  if constexpr (!std::is_same_v<T, Target>)
    type.usage = [](const void* value) { return usage_of(*static_cast<const T*>(value)); };
  return type;
}
template <class T>
constexpr FieldType kFieldType = field_type<T>();

struct Field {
  Keyword keyword;
  void* value;  // in a command that outlives the field
  const FieldType* type;
  bool is_target() const { return !type->usage; }
  const Flag* flag() const { return type == &kFieldType<Flag> ? static_cast<const Flag*>(value) : nullptr; }
};
using Fields = std::vector<Field>;

constexpr std::string_view kAnyTarget = "@knot|@segment|@cart|@section|none";

template <class C>
constexpr std::string_view target_usage() {
  constexpr std::string_view kOfKind[] = {"@knot", "@segment", "@cart", "@section"};
  if constexpr (requires { C::kTargets; }) return C::kTargets;
  else if constexpr (constexpr auto kind = named_kind<C>()) return kOfKind[static_cast<std::size_t>(*kind)];
  else return kAnyTarget;
}

// A kind of command: one row for each, in the order of the list.
struct CommandKind {
  const CommandInfo* info;
  std::string_view target;
  Command (*make)();
  void (*fields)(Command& command, Fields& fields);
  std::string* (*path)(Command& command);  // null: it uses no file
};
template <class C>
constexpr CommandKind kind() {
  constexpr bool uses_file = requires(C c) { c.path; };
  static_assert(uses_file == (C::kInfo.traits.path != PathUse::none),
                "a command with a member `path` says in its traits whether it opens or writes that file");
  CommandKind kind{&C::kInfo, target_usage<C>(), []() -> Command { return C{}; },
                   [](Command& command, Fields& fields) {
                     C::fields(*command.as<C>(), [&]<class T>(std::string_view name, T& value) {
                       fields.push_back({Keyword(name), &value, &kFieldType<T>});
                     });
                   },
                   nullptr};
  if constexpr (uses_file) kind.path = [](Command& command) { return &command.as<C>()->path; };
  return kind;
}
constexpr auto kKinds = Commands::table([]<class C>() { return kind<C>(); });

Fields fields_of(Command& command) {
  Fields fields;
  kKinds[index_of(command)].fields(command, fields);
  return fields;
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandKind& row : kKinds) names.emplace_back(row.info->name);
  return names;
}

std::string usage(const CommandKind& row) {
  Command command = row.make();
  std::string text(row.info->name);
  for (const Field& field : fields_of(command)) {
    const bool place = field.keyword.place;
    std::string part = place ? ":" : field.keyword.word;
    if (!part.empty() && !place && !field.flag()) part += ' ';
    part += field.is_target() ? std::string(row.target) : field.type->usage(field.value);
    if (field.keyword.optional) part = "[" + part + "]";
    text += place ? part : " " + part;
  }
  return text;
}

// Reads one field; returns false if it failed through `words`.
bool read_field(base::WordReader& words, const Field& field) {
  const Keyword& keyword = field.keyword;
  if (!keyword.word.empty()) {
    const bool here = words.peek() && keyword.is(words.peek()->text);
    if (keyword.optional && !here) return true;
    const Names one{here ? words.peek()->text : keyword.word};
    if (!words.one_of(keyword.place ? "a place such as @s3:0.5" : fmt::format("\"{}\"", keyword.word), one))
      return false;
  }
  return field.type->read(words, field.value);
}

// Returns the text for "{KEYWORD}" or "{KEYWORD?on|off}" in CommandInfo::done.
std::string done_part(const Fields& fields, std::string_view part, const world::Document& document) {
  const std::size_t choice = part.find('?');
  const std::string_view keyword = part.substr(0, choice);
  const auto found = std::ranges::find_if(fields, [&](const Field& f) { return f.keyword.word == keyword; });
  if (found == fields.end()) return {};
  std::string words = found->type->words(found->value, document);
  if (choice == std::string_view::npos) return words;
  const std::size_t other = part.find('|', choice);
  return std::string(words == "on" ? part.substr(choice + 1, other - choice - 1) : part.substr(other + 1));
}

// Returns the words with "@s3:0.5" as the three of its former form, "@s3", "at" and "0.5".
std::vector<base::Token> apart(std::span<const base::Token> tokens, const std::string& at) {
  std::vector<base::Token> all;
  for (const base::Token& token : tokens) {
    const std::size_t colon = token.quoted || token.text.starts_with(':') ? std::string::npos : token.text.find(':');
    if (colon == std::string::npos) {
      all.push_back(token);
      continue;
    }
    const int column = token.column + static_cast<int>(colon);
    all.push_back({token.text.substr(0, colon), token.column});
    all.push_back({at, column});
    if (colon + 1 < token.text.size()) all.push_back({token.text.substr(colon + 1), column + 1});
  }
  return all;
}

}  // namespace

Command::Command() : Command(Undo{}) {}

bool opens_link(const Command& command) {
  const LoadTrack* const load = command.as<LoadTrack>();
  return load != nullptr && exchange::is_link(load->path);
}

std::string* path_of(Command& command) {
  const CommandKind& kind = kKinds[index_of(command)];
  return kind.path ? kind.path(command) : nullptr;
}

const std::string* output_path(const Command& command) {
  return info(command).traits.path == PathUse::writes ? path_of(const_cast<Command&>(command)) : nullptr;
}

std::string print(const Command& command) {
  Command copy = command;  // fields are read and written through the same list
  std::string text(info(copy).name);
  const Fields fields = fields_of(copy);
  const bool of_anything = kKinds[index_of(copy)].target == kAnyTarget &&
                           std::ranges::any_of(fields, [](const Field& f) { return f.is_target(); });
  bool on_segment = false;
  for (const Field& field : fields) {
    if (field.is_target()) {
      const world::EntityName& name = static_cast<const Target*>(field.value)->name;
      on_segment = name.number != 0 && name.kind == world::EntityKind::segment;
    }
    if (field.keyword.optional && of_anything && !on_segment) continue;
    const Flag* const flag = field.flag();
    if (flag && !flag->set) continue;
    const std::string value = field.type->print(field.value);
    if (field.keyword.place) {
      text += ":" + value;
      continue;
    }
    if (!field.keyword.word.empty()) text += " " + field.keyword.word;
    if (!value.empty()) text += " " + value;
  }
  return text;
}

std::string done(const Command& command, const world::Document& document) {
  Command copy = command;
  const Fields fields = fields_of(copy);
  std::string text;
  std::string_view left = info(copy).done;
  for (;;) {
    const std::size_t from = left.find('{');
    text += left.substr(0, from);
    if (from == std::string_view::npos) return text;
    const std::size_t to = left.find('}', from);
    text += done_part(fields, left.substr(from + 1, to - from - 1), document);
    left.remove_prefix(to + 1);
  }
}

const std::vector<CommandHelp>& command_table() {
  static const std::vector<CommandHelp> table = [] {
    std::vector<CommandHelp> rows;
    for (const CommandKind& row : kKinds) rows.push_back({*row.info, usage(row)});
    return rows;
  }();
  return table;
}

bool is_command(std::string_view word) {
  for (const CommandHelp& row : command_table())
    if (row.info.name == word) return true;
  return false;
}

base::Result<Command> parse(std::span<const base::Token> tokens, base::TextError& error) {
  const auto failed = [&] { return base::Status{base::Code::usage, error.message}; };
  if (tokens.empty()) {
    error = {1, "expected a command"};
    return failed();
  }
  const auto* const row =
      std::ranges::find_if(kKinds, [&](const CommandKind& kind) { return kind.info->name == tokens[0].text; });
  if (row == kKinds.end()) {
    error = {tokens[0].column, fmt::format("no command {}{}", base::quoted_start(tokens[0].text),
                                           base::suggestion(tokens[0].text, command_names()))};
    return failed();
  }
  Command result = row->make();
  const Fields fields = fields_of(result);
  const auto place = std::ranges::find_if(fields, [](const Field& field) { return field.keyword.place; });
  std::vector<base::Token> former;
  if (place != fields.end()) tokens = former = apart(tokens, place->keyword.word);
  base::WordReader words(tokens, error);
  words.take("a command");
  const bool read = std::ranges::all_of(fields, [&](const Field& field) { return read_field(words, field); });
  if (read && words.at_end()) return result;
  if (read) words.fail(words.peek()->column, "unexpected " + base::quoted_start(words.peek()->text));
  // Where no word was meant, the whole form helps, unless it is as long as that of an element.
  constexpr std::size_t kLongestUsage = 120;
  const std::string form = usage(*row);
  if (!error.out_of_range && !error.suggests && form.size() <= kLongestUsage) error.message += "; usage: " + form;
  return failed();
}

}  // namespace coaster::edit
