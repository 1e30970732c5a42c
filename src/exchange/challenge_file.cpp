// Parses challenges from JSON.
#include "exchange/challenge_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "exchange/formats.h"
#include "exchange/own/json_fields.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {
namespace {

struct ChallengeParse {
  LoadedChallenge loaded;
  std::string error;  // the first error, without the file's name
};

// Reads a text of at least one character and at most the limit.
bool read_text(Fields& fields, std::string_view member, std::string& to) {
  if (!fields.text(member, to)) return false;
  if (to.empty()) return fields.fail(member, "expected a text, found \"\"");
  return to.size() <= kMaxChallengeText ||
         fields.fail(member, fmt::format("longer than the limit of {} bytes", kMaxChallengeText));
}

bool read_challenge_head(ChallengeParse& parse, Fields& fields) {
  ChallengeFile& to = parse.loaded.challenge;
  std::string judged;
  if (!fields.head(kChallengeFormat, kChallengeVersion)) return false;
  if (!read_text(fields, "name", to.name) || !read_text(fields, "teaches", to.teaches) ||
      !fields.text("judged", judged))
    return false;
  const auto found = base::value_named<Judged>(judged);
  if (!found) return fields.reject("judged", base::alternatives_of<Judged>("\""));
  to.judged = *found;
  constexpr double kShortest = 1;  // s
  return to.judged != Judged::time || fields.number("seconds", to.seconds, kShortest, kMaxChallengeSeconds);
}

bool read_rules(ChallengeParse& parse, Fields& fields, RuleList which) {
  const std::string_view name = base::name_of(which);
  if (which != RuleList::goals && !fields.has(name)) return true;
  const Json* const list = fields.list(name, kMaxChallengeRules);
  if (!list) return false;
  if (which == RuleList::goals && list->empty()) return fields.fail(name, "expected one goal at least");
  for (std::size_t i = 0; i < list->size(); ++i) {
    Fields entry((*list)[i], {name, i}, parse.error);
    ChallengeRule rule;
    if (!read_text(entry, "expect", rule.expect) || !read_text(entry, "text", rule.text)) return false;
    (void)entry.unknown(parse.loaded.warnings);
    parse.loaded.challenge.rules[static_cast<std::size_t>(which)].push_back(std::move(rule));
  }
  return true;
}

// Reads an optional list of texts.
bool read_texts(Fields& fields, std::string_view member, std::size_t most, std::vector<std::string>& to) {
  if (!fields.has(member)) return true;
  const Json* const list = fields.list(member, most);
  if (!list) return false;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Json& text = (*list)[i];
    const bool fits = text.is_string() && !text.get_ref<const std::string&>().empty() &&
                      text.get_ref<const std::string&>().size() <= kMaxChallengeText;
    if (!fits) return fields.fail(fmt::format("{}[{}]", member, i), "expected a text, found " + describe(text));
    to.push_back(text.get<std::string>());
  }
  return true;
}

// Reads the start track: a file next to the challenge, or a whole track as a member. Errors in it are reported as for
// any track.
bool read_track(ChallengeParse& parse, Fields& fields, const Json& tree, const std::filesystem::path& folder,
                base::Files& files) {
  ChallengeFile& to = parse.loaded.challenge;
  const auto inside = tree.find("track");
  base::Result<LoadedTrack> track = base::Status{base::Code::bad_file, "no track"};
  if (inside != tree.end() && inside->is_object()) {
    track = parse_track(json_line(*fields.object("track")), "track");
  } else {
    if (!read_text(fields, "track", to.track)) return false;
    const std::filesystem::path path = folder / to.track;
    const Format* const format = format_of(path);
    if (format == nullptr || !format->parse)
      return fields.reject("track",
                           "the start track: an object, or a file that ends in " + known_endings(Direction::read));
    track = load_track(files, path);
  }
  if (!track) return fields.fail("track", track.status().message);
  for (std::string& warning : track->warnings) parse.loaded.warnings.push_back("track: " + std::move(warning));
  to.start = std::move(track->document);
  return true;
}

bool read_all(ChallengeParse& parse, const Json& tree, const std::filesystem::path& folder, base::Files& files) {
  Fields fields(tree, {}, parse.error);
  if (!parse.error.empty() || !read_challenge_head(parse, fields)) return false;
  for (const RuleList which : {RuleList::goals, RuleList::limits, RuleList::bronze, RuleList::silver, RuleList::gold})
    if (!read_rules(parse, fields, which)) return false;
  ChallengeFile& to = parse.loaded.challenge;
  if (!read_texts(fields, "hints", kMaxChallengeHints, to.hints) ||
      !read_texts(fields, "locks", kMaxChallengeLocks, to.locks) || !read_track(parse, fields, tree, folder, files))
    return false;
  (void)fields.unknown(parse.loaded.warnings);
  return true;
}

}  // namespace

base::Result<LoadedChallenge> parse_challenge(std::string_view text, std::string_view name,
                                              const std::filesystem::path& folder, base::Files& files) {
  const base::Result<Json> tree = read_json(text, name);
  if (!tree) return tree.status();
  ChallengeParse parse;
  if (!read_all(parse, *tree, folder, files)) return bad_file(name, parse.error);
  name_ignored(parse.loaded.warnings, name);
  return std::move(parse.loaded);
}

base::Result<LoadedChallenge> load_challenge(base::Files& files, const std::filesystem::path& path) {
  const base::Result<std::string> text = read_json_file(files, path);
  if (!text) return text.status();
  return parse_challenge(*text, path.string(), path.parent_path(), files);
}

bool looks_like_challenge(std::string_view text) {
  const base::Result<Json> tree = read_json(text, "");
  if (!tree) return false;
  const auto format = tree->find("format");
  return format != tree->end() && format->is_string() && format->get_ref<const std::string&>() == kChallengeFormat;
}

}  // namespace coaster::exchange
