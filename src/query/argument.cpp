#include "query/argument.h"

#include <algorithm>

#include <fmt/format.h>

namespace coaster::query {
namespace {

std::vector<std::string> words_of(const ArgumentPart& part) {
  return part.words ? part.words() : std::vector<std::string>();
}

// Returns what the part accepts: "a knot such as @k3", "document or motion", "1 to 3".
std::string expected(const ArgumentPart& part) {
  if (part.kind) return fmt::format("a {} such as @{}", base::name_of(*part.kind), world::to_text({*part.kind, 3}));
  if (part.number) return fmt::format("a number ({})", part.usage);
  if (!part.words && part.most == 0) return std::string(part.usage);
  const std::string range = fmt::format("1 to {}", part.most);
  if (!part.words) return range;
  std::vector<std::string> all = part.words();
  if (part.most > 0) all.push_back(range);
  return base::alternatives(all);
}

bool accepts(const ArgumentPart& part, std::string_view word) {
  if (part.kind) {
    const auto name = world::parse_name(word.starts_with('@') ? word.substr(1) : word);
    return name && name->kind == *part.kind;
  }
  if (part.number) return base::parse_double(word).has_value();
  if (!part.words && part.most == 0) return !word.empty();
  const auto whole = base::parse_int(word);
  if (whole && *whole >= 1 && *whole <= part.most) return true;
  const std::vector<std::string> words = words_of(part);
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string usage_of(Argument argument) {
  std::string text;
  for (const ArgumentPart& part : argument) {
    std::string own(part.usage);
    if (part.before != 0) own.insert(own.begin(), part.before);
    if (part.usage.empty())
      for (const std::string& word : words_of(part)) own += (own.empty() ? "" : "|") + word;
    text += part.optional ? fmt::format("[{}]", own) : own;
  }
  return text;
}

std::optional<base::TextError> wrong_argument(Argument argument, std::string_view word) {
  std::string_view rest = word;
  for (std::size_t i = 0; i < argument.size(); ++i) {
    const ArgumentPart& part = argument[i];
    if (i > 0) {
      if (rest.empty() && part.optional) return std::nullopt;
      if (rest.empty())
        return base::TextError{1, fmt::format("expected {}, found {}", usage_of(argument), base::quoted_start(word))};
      rest.remove_prefix(1);
    }
    const std::size_t end =
        i + 1 < argument.size() ? std::min(rest.find(argument[i + 1].before), rest.size()) : rest.size();
    const std::string_view own = rest.substr(0, end);
    if (!accepts(part, own)) {
      const std::string hint = base::suggestion(own, words_of(part));
      return base::TextError{1 + static_cast<int>(word.size() - rest.size()),
                             fmt::format("expected {}, found {}{}", expected(part), base::quoted_start(own), hint),
                             !part.kind && base::is_number(own), !hint.empty()};
    }
    rest.remove_prefix(end);
  }
  return std::nullopt;
}

}  // namespace coaster::query
