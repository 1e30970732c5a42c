// Scripts read anywhere and write only below $OUT.
#include "script/paths.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "base/files.h"
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

bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto inner = std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  const auto outer = std::filesystem::weakly_canonical(std::filesystem::absolute(folder, ignored), ignored);
  const auto [at, unused] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return at == outer.end();
}

base::Result<std::filesystem::path> find_output(std::string_view written, const std::filesystem::path& out) {
  std::string_view rest;
  if (!below_out(written, rest) || rest.empty() || !lies_below(out / rest, out))
    return base::Status{base::Code::usage, "scripts write only below $OUT, found " + base::quoted(written)};
  const std::filesystem::path path = out / rest;
  if (const base::Status made = make_folder(path.parent_path()); !made) return made;
  return path;
}

base::Status make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return {base::Code::io, fmt::format("{}: cannot be made: {}", folder.string(), error.message())};
  base::Files files;
  const std::filesystem::path probe = folder / ".coaster-probe";
  if (const base::Status wrote = files.write_atomic(probe, ""); !wrote) return wrote;
  std::filesystem::remove(probe, error);
  return {};
}

}  // namespace coaster::script
