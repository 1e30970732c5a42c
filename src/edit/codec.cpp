// Printing, parsing and describing commands, all from their lists of fields. The values' text is in
// codec_values.cpp.
#include "edit/codec.h"

#include <type_traits>
#include <utility>

#include "edit/codec_values.h"

namespace coaster::edit {
namespace {

// "at?" is the keyword "at" of an optional field: it makes sense for segments alone and is printed for them
// alone.
struct Keyword {
  std::string word;
  bool optional = false;
  explicit Keyword(std::string_view text) : word(text), optional(text.ends_with('?')) {
    if (optional) word.pop_back();
  }
};

// Calls fn with a default-made command of each kind, in the order of the variant.
template <class Fn>
void for_each_kind(Fn fn) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (fn(std::variant_alternative_t<I, AnyCommand>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<AnyCommand>>{});
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for_each_kind([&](const auto& command) { names.emplace_back(command.kInfo.name); });
  return names;
}

template <class C>
std::string target_usage() {
  if constexpr (requires(C c) { c.segment; })
    return "@segment";
  else if constexpr (requires(C c) { c.cart; })
    return "@cart";
  else if constexpr (std::is_same_v<C, RemoveKnot>)
    return "@knot|@cart";
  else if constexpr (requires(C c) { c.knot; })
    return "@knot";
  else
    return "@knot|@segment|@cart|none";
}

template <class C>
std::string usage(const C& command) {
  std::string text(C::kInfo.name);
  C::fields(command, [&](std::string_view name, const auto& value) {
    const Keyword keyword(name);
    std::string part = keyword.word.empty() ? "" : keyword.word + " ";
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Target>)
      part += target_usage<C>();
    else
      part += usage_of(value);
    text += keyword.optional ? " [" + part + "]" : " " + part;
  });
  return text;
}

// Reads one field; true unless it failed through `words`.
template <class T>
bool read_field(WordReader& words, std::string_view name, T& value) {
  const Keyword keyword(name);
  if (!keyword.word.empty()) {
    if (keyword.optional && (!words.peek() || words.peek()->text != keyword.word)) return true;
    const base::Token* const word = words.take("\"" + keyword.word + "\"");
    if (!word) return false;
    if (word->text != keyword.word) {
      const std::vector<std::string> candidates{keyword.word};
      return words.reject("\"" + keyword.word + "\"", base::suggestion(word->text, candidates));
    }
  }
  return read_value(words, value);
}

}  // namespace

Command::Command() = default;
Command::Command(const Command& other) = default;
Command::Command(Command&& other) noexcept = default;
Command& Command::operator=(const Command& other) = default;
Command& Command::operator=(Command&& other) noexcept = default;
Command::~Command() = default;

const CommandInfo& info(const Command& command) {
  return std::visit([](const auto& c) -> const CommandInfo& { return c.kInfo; }, command);
}

const std::string* output_path(const Command& command) {
  if (const Save* const save = std::get_if<Save>(&command)) return &save->path;
  if (const SaveMeasurements* const save = std::get_if<SaveMeasurements>(&command)) return &save->path;
  if (const SaveReport* const save = std::get_if<SaveReport>(&command)) return &save->path;
  return nullptr;
}

void set_output_path(Command& command, std::string path) {
  if (Save* const save = std::get_if<Save>(&command)) save->path = std::move(path);
  else if (SaveMeasurements* const table = std::get_if<SaveMeasurements>(&command)) table->path = std::move(path);
  else if (SaveReport* const report = std::get_if<SaveReport>(&command)) report->path = std::move(path);
}

std::string print(const Command& command) {
  return std::visit(
      [](const auto& c) {
        std::string text(c.kInfo.name);
        bool on_segment = false;
        c.fields(c, [&](std::string_view name, const auto& value) {
          const Keyword keyword(name);
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Target>)
            on_segment = value.name.number != 0 && value.name.kind == world::Kind::segment;
          if (keyword.optional && !on_segment) return;
          if (!keyword.word.empty()) text += " " + keyword.word;
          text += " " + print_value(value);
        });
        return text;
      },
      command);
}

const std::vector<CommandHelp>& command_table() {
  static const std::vector<CommandHelp> table = [] {
    std::vector<CommandHelp> rows;
    for_each_kind([&](const auto& command) { rows.push_back({command.kInfo, usage(command)}); });
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
  if (!is_command(tokens[0].text)) {
    error = {tokens[0].column, "no command " + base::quoted(tokens[0].text) +
                                   base::suggestion(tokens[0].text, command_names())};
    return failed();
  }
  WordReader words(tokens, error);
  words.take("a command");
  Command result;
  bool good = true;
  for_each_kind([&](auto command) {
    if (command.kInfo.name != tokens[0].text) return;
    command.fields(
        command, [&](std::string_view name, auto& value) { good = good && read_field(words, name, value); });
    if (good && words.peek()) {
      const base::Token& extra = *words.peek();
      good =
          words.fail(extra.column, "unexpected " + base::quoted(extra.text) + "; usage: " + usage(command));
    }
    result = std::move(command);
  });
  if (!good) return failed();
  return result;
}

}  // namespace coaster::edit
