// The font of the panels: Inter if it was embedded at build time, else Dear ImGui's own.
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "platform/system.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/letters.h"
#include "ui/widgets/theme.h"

#ifdef COASTER_HAS_INTER_FONT
namespace coaster::embedded {
extern const unsigned char inter_font[];
extern const std::size_t inter_font_size;
}  // namespace coaster::embedded
#endif

namespace coaster::ui {
namespace {

// Latin, Greek, punctuation, super- and subscripts, arrows, operators: what formulas and names need.
const ImWchar kRanges[] = {0x0020, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2030, 0x203A, 0x2070,
                           0x209F, 0x2190, 0x2199, 0x2200, 0x2265, 0x25A0, 0x25CF, 0};
const ImWchar kTitleRanges[] = {0x0020, 0x007E, kBox, kBox, 0};
constexpr std::size_t kMostBlocks = 1024;

// True if a file has outlines that Dear ImGui reads.
bool has_outlines(std::string_view file, int index) {
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::size_t value = 0;
    for (; bytes-- > 0; ++at) value = value << 8 | (at < file.size() ? static_cast<unsigned char>(file[at]) : 0U);
    return value;
  };
  const std::size_t start = file.starts_with("ttcf") ? number(12 + 4 * static_cast<std::size_t>(index), 4) : 0;
  bool letters = false, outlines = false;
  for (std::size_t i = 0, at = start + 12; i < number(start + 4, 2) && at + 4 <= file.size(); ++i, at += 16) {
    const std::string_view table = file.substr(at, 4);
    letters = letters || table == "cmap";
    outlines = outlines || table == "glyf" || table == "CFF ";
  }
  return letters && outlines;
}

}  // namespace

std::span<const unsigned char> inter_font() {
#ifdef COASTER_HAS_INTER_FONT
  return {embedded::inter_font, embedded::inter_font_size};
#else
  return {};
#endif
}

ImFont* Letters::add_font(float pixels, const ImWchar* base) const {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.SizePixels = std::max(13.0f, pixels);
  const std::span<const unsigned char> inter = inter_font();
  if (inter.empty()) return atlas.AddFontDefault(&config);
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = pixels < 40 ? 3 : 1;  // large letters need no finer steps, but much memory
  config.OversampleV = 1;
  config.PixelSnapH = false;
  config.RasterizerMultiply = 1.1f;  // light text on dark looks thin otherwise
  // The atlas only reads data it does not own.
  ImFont* const font = atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(inter.data()),
                                                  static_cast<int>(inter.size()), pixels, &config, base);
  font->FallbackChar = kBox;
  config.MergeMode = true;
  config.OversampleH = 1;
  if (base == ranges_.data())
    for (const File& file : files_) {
      config.FontNo = file.index;
      atlas.AddFontFromMemoryTTF(const_cast<char*>(file.bytes.data()), static_cast<int>(file.bytes.size()), pixels,
                                 &config, base);
    }
  return font;
}

bool Letters::build() {
  ranges_.assign(std::begin(kRanges), std::end(kRanges) - 1);
  for (const ImWchar block : blocks_) ranges_.insert(ranges_.end(), {block, ImWchar(block + kBlock - 1)});
  ranges_.push_back(0);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  begin_fonts(atlas);
  atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
  add_font(std::round(kFontPixels * scale_), ranges_.data());
  add_font(std::max(13.0f, std::round(kSmallFontPixels * scale_)), ranges_.data());
  add_font(std::round(kTitleFontPixels * scale_), kTitleRanges);
  return finish_fonts(atlas, blocks_);
}

// Adds files of the system for letters that the fonts lack. Returns true if it found any.
bool Letters::add_files(const std::set<ImWchar>& blocks) {
  std::vector<unsigned> lacking;
  for (const ImWchar block : blocks)
    for (int c = block; c < block + kBlock; ++c) {
      const bool is_private = c >= 0xE000 && c <= 0xF8FF;  // of fonts of pictures, which Dear ImGui does not read
      if (!is_private && !has_glyph(*ImGui::GetIO().Fonts->Fonts[0], static_cast<ImWchar>(c)))
        lacking.push_back(static_cast<unsigned>(c));
    }
  const std::size_t before = files_.size();
  for (const platform::SystemFont& font : platform::fonts_with(std::move(lacking))) {
    if (std::ranges::find(files_, font.path, &File::path) != files_.end()) continue;
    base::Result<std::string> bytes = base::Files().read(font.path);
    if (bytes && has_outlines(*bytes, font.index)) files_.push_back({font.path, std::move(*bytes), font.index});
  }
  return files_.size() > before;
}

bool Letters::load(float scale) {
  std::set<ImWchar> blocks;
  take_missing(blocks);
  std::erase_if(blocks, [&](ImWchar block) { return blocks_.contains(block); });
  if (blocks_.size() > kMostBlocks) blocks_.clear();
  for (const ImWchar block : blocks) {
    // Inter's alphabets come as a whole: the next word has other letters of them.
    const bool is_of_inter = block < 0x500 || (block >= 0x1E00 && block < 0x2000);
    const unsigned page = is_of_inter ? 256 : kBlock, first = block / page * page;
    for (unsigned i = first; i < first + page; i += kBlock) blocks_.insert(static_cast<ImWchar>(i));
  }
  if (scale == std::exchange(scale_, scale) && blocks.empty()) return false;
  build();
  if (!inter_font().empty() && add_files(blocks) && !build()) files_.clear(), build();
  return true;
}

void load_fonts(float scale) { Letters().load(scale); }

ImFont* small_font() { return ImGui::GetIO().Fonts->Fonts[1]; }
float small_pixels() { return pixels_of(*small_font()); }
ImFont* title_font() { return ImGui::GetIO().Fonts->Fonts[2]; }

}  // namespace coaster::ui
