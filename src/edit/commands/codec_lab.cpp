// Values of the laboratory's commands as text: layers, colourings and pages, the theme's and the style's, by the names
// of their tables.
#include "edit/commands/codec_values.h"

namespace coaster::edit {
namespace {

Names layer_names() { return names_of(world::layers()); }
Names colouring_names() { return names_of(world::colourings()); }
Names page_names() { return names_of(world::lab_pages()); }
Names theme_names() { return Names(world::kThemeNames.begin(), world::kThemeNames.end()); }
Names style_names() { return Names(world::kStyleNames.begin(), world::kStyleNames.end()); }

}  // namespace

std::string print_value(world::Layer value) { return row_name(layer_names(), static_cast<int>(value)); }
std::string print_value(world::Colouring value) { return row_name(colouring_names(), static_cast<int>(value)); }
std::string print_value(world::LabPage value) { return row_name(page_names(), static_cast<int>(value)); }
std::string print_value(world::Theme value) { return row_name(theme_names(), static_cast<int>(value)); }
std::string print_value(world::Style value) { return row_name(style_names(), static_cast<int>(value)); }
bool read_value(WordReader& words, world::Layer& value) { return read_enum(words, layer_names(), value); }
bool read_value(WordReader& words, world::Colouring& value) { return read_enum(words, colouring_names(), value); }
bool read_value(WordReader& words, world::LabPage& value) { return read_enum(words, page_names(), value); }
bool read_value(WordReader& words, world::Theme& value) { return read_enum(words, theme_names(), value); }
bool read_value(WordReader& words, world::Style& value) { return read_enum(words, style_names(), value); }
std::string usage_of(world::Layer) { return joined(layer_names()); }
std::string usage_of(world::Colouring) { return joined(colouring_names()); }
std::string usage_of(world::LabPage) { return joined(page_names()); }
std::string usage_of(world::Theme) { return joined(theme_names()); }
std::string usage_of(world::Style) { return joined(style_names()); }

}  // namespace coaster::edit
