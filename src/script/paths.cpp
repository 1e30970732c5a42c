// Scripts read anywhere and write only below $OUT.
#include "script/paths.h"

#include <system_error>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::script {
namespace {

constexpr std::string_view kOut = "$OUT";

// Splits off the rest after "$OUT/", if the path starts with it.
bool below_out(std::string_view written, std::string_view& rest) {
  if (!written.starts_with(kOut)) return false;
  rest = written.substr(kOut.size());
  if (!rest.empty() && rest.front() != '/') return false;
  while (rest.starts_with('/')) rest.remove_prefix(1);
  return true;
}

}  // namespace

std::filesystem::path find_input(const std::filesystem::path& folder, std::string_view written,
                                 const std::filesystem::path& out) {
  std::string_view rest;
  if (!out.empty() && below_out(written, rest)) return out / rest;
  const std::filesystem::path path(written);
  if (path.is_absolute()) return path;
  std::error_code ignored;
  const std::filesystem::path beside = folder / path;
  return std::filesystem::exists(beside, ignored) ? beside : path;
}

std::string not_below_out(std::string_view written) {
  std::string name = std::filesystem::path(written).filename().string();
  if (name.empty() || name == ".." || name == "." || name == kOut) name = "NAME";
  return fmt::format("scripts write only below $OUT: expected a file such as {}, found {}",
                     base::quoted_start(fmt::format("{}/{}", kOut, name)), base::quoted_start(written));
}

base::Result<std::filesystem::path> find_output(std::string_view written, const base::FileRoot& out) {
  std::string_view rest;
  if (!below_out(written, rest) || rest.empty() || !out.contains(out.folder() / rest))
    return base::Status{base::Code::usage, not_below_out(written)};
  const std::filesystem::path path = out.folder() / rest;
  if (const base::Status made = out.make_folders(path.parent_path()); !made) return made;
  return path;
}

}  // namespace coaster::script
