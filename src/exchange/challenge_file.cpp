// Parses challenges from JSON.
#include "exchange/challenge_file.h"

#include <fmt/format.h>

#include "exchange/formats.h"
#include "exchange/own/json.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {
namespace {

// Reads a text of at least one character and at most the limit.
bool read_text(JsonFieldReader& fields, std::string_view member, std::string& to) {
  if (!fields.text(member, to)) return false;
  if (to.empty()) return fields.fail(member, "expected a text, found \"\"");
  return to.size() <= kMaxChallengeText ||
         fields.fail(member, fmt::format("longer than the limit of {} bytes", kMaxChallengeText));
}

bool read_challenge_head(JsonFieldReader& fields, ChallengeFile& to) {
  constexpr double kShortest = 1;  // s
  return fields.head(kChallengeFormat, kChallengeVersion) && read_text(fields, "name", to.name) &&
         read_text(fields, "teaches", to.teaches) && fields.named("judged", to.judged) &&
         (to.judged != JudgedWhen::time || fields.number("seconds", to.seconds, kShortest, kMaxChallengeSeconds));
}

bool read_rules(JsonFieldReader& fields, RuleList which, LoadedChallenge& to) {
  const std::string_view name = base::name_of(which);
  if (which != RuleList::goals && !fields.has(name)) return true;
  std::vector<ChallengeRule>& rules = to.challenge.rules[static_cast<std::size_t>(which)];
  const auto read_rule = [&](JsonFieldReader& entry, auto) {
    ChallengeRule& rule = rules.emplace_back();
    if (!read_text(entry, "expect", rule.expect) || !read_text(entry, "text", rule.text)) return false;
    (void)entry.unknown(to.warnings);
    return true;
  };
  return fields.each(name, kMaxChallengeRules, read_rule) &&
         (which != RuleList::goals || !rules.empty() || fields.fail(name, "expected one goal at least"));
}

// Reads an optional list of texts.
bool read_texts(JsonFieldReader& fields, std::string_view member, std::size_t most, std::vector<std::string>& to) {
  if (!fields.has(member)) return true;
  const Json* const list = fields.list(member, most);
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const Json& text = (*list)[i];
    const bool fits = text.is_string() && !text.get_ref<const std::string&>().empty() &&
                      text.get_ref<const std::string&>().size() <= kMaxChallengeText;
    if (!fits) return fields.fail(fmt::format("{}[{}]", member, i), "expected a text, found " + describe(text));
    to.push_back(text.get<std::string>());
  }
  return list != nullptr;
}

// Reads the start track: a file next to the challenge, or a whole track as a member. Errors in it are reported as for
// any track.
bool read_track(JsonFieldReader& fields, LoadedChallenge& to, const std::filesystem::path& folder, base::Files& files) {
  base::Result<LoadedTrack> track = base::Status{base::Code::bad_file, "no track"};
  if (const Json* const inside = fields.has_object("track") ? fields.object("track") : nullptr) {
    track = parse_track(json_line(*inside), "track");
  } else {
    if (!read_text(fields, "track", to.challenge.track)) return false;
    const std::filesystem::path path = folder / to.challenge.track;
    const TrackFormat* const format = format_of(path);
    if (format == nullptr || !format->parse)
      return fields.reject("track",
                           "the start track: an object, or a file that ends in " + known_endings(FormatUse::read));
    track = load_track(files, path);
  }
  if (!track) return fields.fail("track", track.status().message);
  for (std::string& warning : track->warnings) to.warnings.push_back("track: " + std::move(warning));
  to.challenge.start = std::move(track->document);
  return true;
}

}  // namespace

base::Result<LoadedChallenge> parse_challenge(std::string_view text, std::string_view name,
                                              const std::filesystem::path& folder, base::Files& files) {
  const auto read = [&](JsonFieldReader& fields, LoadedChallenge& to) {
    if (!read_challenge_head(fields, to.challenge)) return false;
    for (std::size_t which = 0; which < base::count_of<RuleList>(); ++which)
      if (!read_rules(fields, static_cast<RuleList>(which), to)) return false;
    const bool good = read_texts(fields, "hints", kMaxChallengeHints, to.challenge.hints) &&
                      read_texts(fields, "locks", kMaxChallengeLocks, to.challenge.locks) &&
                      read_track(fields, to, folder, files);
    if (good) (void)fields.unknown(to.warnings);
    return good;
  };
  base::Result<LoadedChallenge> loaded = read_object<LoadedChallenge>(text, name, read);
  if (loaded) name_ignored(loaded->warnings, name);
  return loaded;
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
