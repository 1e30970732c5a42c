// The table of formats, and looking things up in it.
#include "exchange/formats.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/words.h"
#include "exchange/export/track_shapes.h"
#include "exchange/nolimits/nl2_csv.h"
#include "exchange/nolimits/nl2elem.h"
#include "exchange/nolimits/nltrack.h"

namespace coaster::exchange {
namespace {

std::string print_rows(const world::Document& document) { return print_nl2_csv(document, kNl2Spacing); }
base::Status check_rows(const world::Document& document) { return check_nl2_csv(document, kNl2Spacing); }

constexpr std::array kFormats{
    Format{".json", "coaster track", parse_track, print_track, false, true},
    Format{".nltrack", "NoLimits 1 track", parse_nltrack, nullptr, true, false},
    Format{".csv", "NoLimits 2 track spline", parse_nl2_csv, print_rows, false, false, check_rows,
           parse_nl2_csv_watched},
    Format{".nl2elem", "NoLimits 2 element", parse_nl2elem, print_nl2elem, false, false, check_nl2elem},
    Format{".gltf", "glTF 2.0", nullptr, print_gltf, false, false},
    Format{".obj", "Wavefront OBJ", nullptr, print_obj, false, false},
    Format{".svg", "drawing", nullptr, print_svg, false, false},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* format_of(const std::filesystem::path& path) {
  const std::string ending = base::lower(path.extension().string());
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.ending == ending; });
  return found == kFormats.end() ? nullptr : &*found;
}

std::string known_endings(Direction direction) {
  std::vector<std::string_view> endings;
  for (const Format& f : kFormats)
    if (direction == Direction::read ? f.parse != nullptr : f.print != nullptr) endings.push_back(f.ending);
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i)
    text += (i == 0 ? "" : i + 1 < endings.size() ? ", " : " or ") + std::string(endings[i]);
  return text;
}

}  // namespace coaster::exchange
