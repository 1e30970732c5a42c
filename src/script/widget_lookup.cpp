// Matching of label paths.
#include "script/widget_lookup.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::script {
namespace {

bool ends_in(std::string_view path, std::string_view tail) {
  return path.size() > tail.size() && path.ends_with(tail) && path[path.size() - tail.size() - 1] == '/';
}

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t slash = path.find('/');
    parts.push_back(base::lower(path.substr(0, slash)));
    if (slash == std::string_view::npos) return parts;
    path.remove_prefix(slash + 1);
  }
}

// True if the wanted parts occur in `path` in order, the last one last.
bool has_parts(std::string_view path, const std::vector<std::string>& want) {
  const auto have = parts_of(path);
  if (have.back() != want.back()) return false;
  std::size_t next = 0;
  for (const std::string& part : have)
    if (next < want.size() && part == want[next]) ++next;
  return next == want.size();
}

template <class Fits>
std::vector<std::size_t> all(std::span<const query::Widget> widgets, Fits fits) {
  std::vector<std::size_t> found, labels;
  for (std::size_t i = 0; i < widgets.size(); ++i)
    if (fits(widgets[i].path) || (!widgets[i].alias.empty() && fits(widgets[i].alias)))
      (widgets[i].kind == "label" ? labels : found).push_back(i);
  return found.empty() ? labels : found;
}

std::string last_part(std::string_view path) { return std::string(path.substr(path.rfind('/') + 1)); }

std::string nearest_path(std::span<const query::Widget> widgets, std::string_view path) {
  std::vector<std::string> paths;
  for (const query::Widget& widget : widgets) paths.push_back(widget.path);
  if (std::string hint = base::suggestion(path, paths); !hint.empty()) return hint;
  std::vector<std::string> ends;
  for (const query::Widget& widget : widgets) ends.push_back(last_part(widget.path));
  const auto near = base::nearest(last_part(path), ends);
  if (!near) return {};
  const auto at = std::find(ends.begin(), ends.end(), *near) - ends.begin();
  return fmt::format("; did you mean {}?", base::quoted_start(paths[static_cast<std::size_t>(at)]));
}

}  // namespace

std::vector<std::size_t> find_widgets(std::span<const query::Widget> widgets, std::string_view path) {
  if (path.size() > kMostPathBytes) return {};
  auto found = all(widgets, [&](std::string_view p) { return p == path; });
  if (found.empty()) found = all(widgets, [&](std::string_view p) { return ends_in(p, path); });
  const std::string low = base::lower(path);
  if (found.empty()) found = all(widgets, [&](std::string_view p) { return base::lower(p) == low; });
  if (found.empty()) found = all(widgets, [&](std::string_view p) { return ends_in(base::lower(p), low); });
  if (found.empty()) found = all(widgets, [want = parts_of(path)](std::string_view p) { return has_parts(p, want); });
  return found;
}

base::Result<std::size_t> find_widget(std::span<const query::Widget> widgets, std::string_view path) {
  if (path.size() > kMostPathBytes)
    return base::Status{base::Code::usage, fmt::format("expected a widget's path of at most {} bytes, found {}",
                                                       kMostPathBytes, path.size())};
  const std::vector<std::size_t> found = find_widgets(widgets, path);
  if (found.size() == 1) return found[0];
  if (found.empty())
    return base::Status{base::Code::usage,
                        fmt::format("no widget {}{}", base::quoted_start(path), nearest_path(widgets, path))};
  std::string list;
  for (const std::size_t i : found)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", base::quoted_start(widgets[i].path), widgets[i].kind);
  return base::Status{base::Code::usage, fmt::format("{} matches several widgets: {}", base::quoted_start(path), list)};
}

std::string_view panel_of(std::string_view path) { return path.substr(0, path.find('/')); }

bool is_on(const query::Widget& widget) { return widget.value == "on" || widget.value == "open"; }

bool is_closed_header(const query::Widget& widget) {
  return widget.kind == "header" && (widget.value == "off" || widget.value == "closed");
}

}  // namespace coaster::script
