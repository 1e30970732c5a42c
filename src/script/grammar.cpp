// Files, blocks and includes. statement_rows.cpp reads single lines.
#include "script/grammar.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "base/text.h"
#include "script/paths.h"
#include "script/statement_rows.h"

namespace coaster::script {
namespace {

constexpr std::string_view kHeader = "\"coaster-script 1\"";

// Parses files into one script; continues after an error.
class Parser {
 public:
  // `including`: the files being parsed, outermost first, with this one last. `errors`: those found so far.
  Parser(ParsedScript& out, base::Files& files, std::vector<std::filesystem::path> including, std::size_t& errors)
      : out_(out), files_(files), including_(std::move(including)), errors_(errors) {}

  void file(std::string_view text, const std::string& name, const std::filesystem::path& folder, bool header_required,
            Block& block) {
    source_ = static_cast<int>(out_.script.sources.size());
    Source made{name, folder, {}, from_, from_line_};
    out_.script.sources.push_back(made);
    if (!split(text, made)) return;
    out_.script.sources.back().lines = made.lines;
    const std::vector<std::string> lines = made.lines;  // an include adds to the sources
    block_ = &block;
    header_required_ = header_required;
    for (const std::string& one : lines) ++line_, line(one);
    line_ = 1;
    if (header_required && !header_seen_) error(1, fmt::format("expected {}", kHeader));
    for (const Statement& open : open_) line_ = open.line, error(open.column, "no \"end\" for this block");
  }

 private:
  using Tokens = std::span<const base::Token>;

  const Source& source() const { return out_.script.sources[static_cast<std::size_t>(source_)]; }
  void add(Statement statement) { (open_.empty() ? *block_ : open_.back().body).push_back(std::move(statement)); }

  void error(int column, const std::string& message) {
    if (first_error_ == 0) first_error_ = line_;
    if (++errors_ > kMaxErrors) return;
    ScriptError found{source().name, line_, column, message, {}};
    for (const Source* at = &source(); at->from >= 0; at = &out_.script.sources[static_cast<std::size_t>(at->from)])
      found.from.push_back({out_.script.sources[static_cast<std::size_t>(at->from)].name, at->from_line});
    out_.errors.push_back(describe_error(source(), found));
    out_.problems.push_back(std::move(found));
  }

  void header(Tokens tokens) {
    const auto version = tokens.size() == 2 ? base::parse_int(tokens[1].text) : std::nullopt;
    const int column = tokens.size() > 1 ? tokens[1].column : tokens[0].column;
    if (!version) return error(column, fmt::format("expected {}", kHeader));
    if (*version > kScriptVersion)
      return error(column, fmt::format("the script needs version {}; this program supports version 1", *version));
    if (*version < 1) error(column, "expected version 1");
  }

  void include(Tokens tokens) {
    if (tokens.size() != 2) return error(tokens[0].column, fmt::format("expected {}", usage("include")));
    const std::filesystem::path path = find_input(source().folder, tokens[1].text, {});
    std::error_code ignored;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored);
    if (std::find(including_.begin(), including_.end(), canonical) != including_.end())
      return error(tokens[1].column, fmt::format("the file {} includes itself", base::quoted_start(tokens[1].text)));
    if (static_cast<int>(including_.size()) > kMaxIncludeDepth)
      return error(tokens[1].column, fmt::format("includes are nested more than {} deep", kMaxIncludeDepth));
    const auto text = files_.read(path);
    if (!text) return error(tokens[1].column, text.status().message);
    Statement statement{source_, line_, tokens[0].column, Include{}, {}};
    std::vector<std::filesystem::path> including = including_;
    including.push_back(canonical);
    const std::size_t before = errors_;
    Parser inner(out_, files_, std::move(including), errors_);
    inner.from_ = source_, inner.from_line_ = line_;
    inner.file(*text, path.string(), path.parent_path(), false, statement.body);
    if (!inner.header_seen_ && inner.first_error_ != 0 && inner.first_error_ == inner.first_line_) {
      out_.errors.resize(std::min(before, kMaxErrors)), out_.problems.resize(out_.errors.size());
      errors_ = before;
      return error(tokens[1].column, fmt::format("{} is not a script: its line {} is no statement; begin it with {} "
                                                 "to see its errors",
                                                 base::quoted_start(tokens[1].text), inner.first_line_, kHeader));
    }
    add(std::move(statement));
  }

  void close(Tokens tokens) {
    if (tokens.size() > 1)
      error(tokens[1].column, fmt::format("unexpected {} after end", base::quoted_start(tokens[1].text)));
    if (too_deep_ > 0) return void(--too_deep_);
    if (open_.empty()) return error(tokens[0].column, "\"end\" without repeat, gesture or lesson");
    Statement closed = std::move(open_.back());
    open_.pop_back();
    add(std::move(closed));
  }

  void statement(Tokens tokens) {
    const base::Token& first = tokens.front();
    if (first.text == "end") return close(tokens);
    if (first.text == "include") return include(tokens);
    Statement made{source_, line_, first.column, {}, {}};
    base::TextError problem;
    const bool read = parse_line(tokens, problem, made.action);
    if (!read) error(problem.column, problem.message);
    if (!opens_block(first.text)) return read ? add(std::move(made)) : void();
    // A block with an error in its first line still has its "end".
    if (static_cast<int>(open_.size()) < kMaxBlockDepth) open_.push_back(std::move(made));
    else if (too_deep_++ == 0) error(first.column, fmt::format("blocks are nested more than {} deep", kMaxBlockDepth));
  }

  // Reports a line that is not words. ctx.ItemClick("x") of another language is an unknown command, not a wrong quote.
  void unreadable(const std::string& text, const base::TextError& problem) {
    std::vector<base::Token> called;
    base::TextError ignored;
    const std::vector<std::string>& known = statement_words();
    if (const std::size_t end = text.find('('); end != std::string::npos && static_cast<int>(end) < problem.column)
      if (base::tokenise(std::string_view(text).substr(0, end), called, ignored) && !called.empty() &&
          std::find(known.begin(), known.end(), called[0].text) == known.end())
        return statement(called);
    error(problem.column, problem.message);
  }

  void line(const std::string& text) {
    std::vector<base::Token> tokens;
    base::TextError problem;
    const bool readable = base::tokenise(text, tokens, problem);
    if (first_line_ == 0 && (!readable || !tokens.empty())) first_line_ = line_;
    if (!readable) return unreadable(text, problem);
    if (tokens.empty()) return;
    if (tokens[0].text == "coaster-script") {
      if (header_seen_) return error(tokens[0].column, "a second \"coaster-script\" line");
      header_seen_ = true;
      return header(tokens);
    }
    if (!header_seen_ && header_required_) {
      header_seen_ = true;
      error(tokens[0].column, fmt::format("expected {} before the first statement", kHeader));
    }
    statement(tokens);
  }

  // Splits a file into lines, which end in \n, \r\n or \r. Returns false after an error of the file as a whole; the
  // source then has no lines, so that none is printed.
  bool split(std::string_view text, Source& made) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    const auto refuse = [&](const std::string& message) {
      made.lines.clear();
      header_seen_ = true, line_ = 1;
      error(1, message);
      return false;
    };
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
        text.substr(0, 2).find('\0') != std::string_view::npos)
      return refuse("UTF-16 text: save it as UTF-8");
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    while (!text.empty()) {
      if (++out_.lines > kMaxLines)
        return refuse(fmt::format("more than the limit of {} lines with everything included", kMaxLines));
      const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
      std::string one(text.substr(0, end));
      std::replace(one.begin(), one.end(), '\t', ' ');
      made.lines.push_back(std::move(one));
      text.remove_prefix(end);
      text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
    }
    return true;
  }

  ParsedScript& out_;
  base::Files& files_;
  std::vector<std::filesystem::path> including_;
  std::vector<Statement> open_;  // blocks without their "end" yet
  Block* block_ = nullptr;
  std::size_t& errors_;
  int too_deep_ = 0;                                   // open blocks beyond the limit, which have their "end", too
  int first_line_ = 0;                                 // the first one with words, 0: none
  int first_error_ = 0;                                // its line in this file, 0: none
  int source_ = 0, line_ = 0;                          // the line being parsed
  int from_ = -1, from_line_ = 0;                      // of the source
  bool header_seen_ = false, header_required_ = true;  // an included file may have the header
};

// --- Unknown first words

// Playwright's and imgui_test_engine's words among them, in lower case and without what is before the last dot or arrow
// (page.goto, ctx->ItemClick).
constexpr ForeignWords kForeignWords[]{
    {"assert im_check im_check_eq verify", "expect"},
    {"capture screenshot", "shot"},
    {"click itemclick", "ui.click"},
    {"dblclick itemdoubleclick", "ui.doubleclick"},
    {"hover mousemove", "ui.hover"},
    {"itemcheck itemuncheck uncheck", "ui.check"},
    {"fill iteminput iteminputvalue", "ui.type"},
    {"dragto", "ui.drag"},
    {"itemopen", "ui.open"},
    {"itemclose", "ui.close"},
    {"menuclick", "ui.menu"},
    {"keypress press", "key"},
    {"keychars", "text"},
    {"setinputfiles", "drop"},
    {"setviewportsize", "resize"},
    {"echo print", "log"},
    {"goto import open", "load"},
    {"export write", "save"},
    {"for loop", "repeat"},
    {"}", "end"},
    {"source", "include"},
    {"sleep waitfortimeout yield", "frames"},
    {"//", "; comments begin with #"},
    {"if while", "; scripts have no conditions: wait waits for one, expect checks one"},
    {"const let var", "; scripts have no variables"},
    {"getbylabel getbyrole getbytext locator setref", "; widgets are named by label: ui.click \"Track/Insert point\""},
    {"waitfor waitforselector", "; wait visible \"Track/Insert point\" waits for a widget"},
    {"hold", "; raw.key W down presses a key until raw.key W up"},
    {"set", "; a setting is set by its name and value, such as resolution 64"}};

// True if `word` is one of the words that blanks separate.
bool has_word(std::string_view words, std::string_view word) {
  return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

}  // namespace

ParsedScript parse_script(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                          base::Files& files) {
  ParsedScript out;
  std::error_code ignored;
  const std::filesystem::path file = folder / std::filesystem::path(name).filename();
  std::size_t errors = 0;
  Parser(out, files, {std::filesystem::weakly_canonical(file, ignored)}, errors)
      .file(text, name, folder, true, out.script.statements);
  if (errors > kMaxErrors) out.errors.push_back(fmt::format("and {} more", errors - kMaxErrors));
  return out;
}

base::Result<ParsedScript> parse_script_file(const std::filesystem::path& path, base::Files& files) {
  const auto text = files.read(path);
  if (!text) return base::Status{base::Code::usage, text.status().message};
  return parse_script(*text, path.string(), path.parent_path(), files);
}

exchange::JsonMembers to_json(const ScriptError& error) {
  exchange::JsonList from;
  for (const Origin& origin : error.from) {
    from.push_back({{"file", origin.file}, {"line", std::int64_t{origin.line}}});
    if (origin.pass > 0) from.back().emplace_back("pass", origin.pass), from.back().emplace_back("of", origin.of);
  }
  return {{"file", error.file.empty() ? exchange::JsonValue() : error.file},
          {"line", std::int64_t{error.line}},
          {"column", std::int64_t{error.column}},
          {"message", error.message},
          {"from", std::move(from)}};
}

std::string describe_error(const Source& source, const ScriptError& error, const std::string& note) {
  const auto [line, column] = std::pair(error.line, error.column);
  std::string hint, message = error.message;
  if (const std::size_t at = message.find(" did you mean "); at != std::string::npos) {
    hint = message.substr(at);
    message.resize(at);
    while (message.ends_with(',') || message.ends_with(';')) message.pop_back();
  }
  if (!note.empty()) hint += " (" + note + ")";
  std::string out = base::at_place(source.name, line, column, message);
  if (line >= 1 && static_cast<std::size_t>(line) <= source.lines.size()) {
    const std::string& text = source.lines[static_cast<std::size_t>(line) - 1];
    const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
    const std::size_t to = std::min(static_cast<std::size_t>(std::max(1, column)) - 1, text.size());
    // Of a long line, the part around the error.
    constexpr std::size_t kBefore = 100, kAfter = 100;  // bytes
    const std::size_t from = std::max(blanks, to - std::min(to, kBefore));
    const std::string before = (from > blanks ? "..." : "") +
                               base::visible_text(std::string_view(text).substr(from, to > from ? to - from : 0)),
                      after = base::visible_text(std::string_view(text).substr(std::max(from, to), kAfter)) +
                              (text.size() > std::max(from, to) + kAfter ? "..." : "");
    out += fmt::format("\n    {}{}\n    {}^", before, after, std::string(before.size(), ' '));
  }
  out += hint;
  for (const Origin& from : error.from)
    out += from.pass > 0
               ? fmt::format("\n  in pass {} of {} of the repeat at {}:{}", from.pass, from.of, from.file, from.line)
               : fmt::format("\n  included at {}:{}", from.file, from.line);
  return out;
}

std::span<const ForeignWords> foreign_words() { return kForeignWords; }

std::string near_words(std::span<const base::Token> line) {
  const std::vector<std::string>& known = statement_words();
  if (line.size() > 1)
    if (const std::string dotted = fmt::format("{}.{}", line[0].text, line[1].text);
        std::find(known.begin(), known.end(), dotted) != known.end())
      return base::suggestion(dotted, known);
  const std::string& first = line[line.size() > 1 && line[0].text == "await" ? 1 : 0].text;
  const std::string word = first.substr(0, first.find('('));
  const std::string last = word.substr(word.find_last_of(".>") + 1);
  for (const ForeignWords& row : kForeignWords)
    if (has_word(row.words, base::lower(last)))
      return row.here.starts_with(';') ? std::string(row.here) : fmt::format("; did you mean \"{}\"?", row.here);
  if (std::string near = base::suggestion(word, known); !near.empty()) return near;
  const auto found = std::find_if(known.begin(), known.end(), [&](const std::string& k) {
    return k == word || k.ends_with(fmt::format(".{}", last));
  });
  return found != known.end() ? fmt::format("; did you mean \"{}\"?", *found) : "; coaster --help-script lists all";
}

}  // namespace coaster::script
