#include "world/section_words.h"

#include "base/names.h"
#include "world/element_rows.h"

namespace coaster::world {

std::string words_of(ElementKind kind) {
  std::string words(base::row_of(kind).label);
  // Proper names keep their capitals.
  if (kind != ElementKind::immelmann && kind != ElementKind::s_bend) words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

std::string words_of(const Section& section) {
  if (!section.title.empty()) return '"' + section.title + '"';
  switch (section.kind) {
    case SectionKind::free: return "the hand-shaped section";
    case SectionKind::element: return "the " + words_of(section.element.kind);
    case SectionKind::complete: return "the closing section";
    case SectionKind::force: return "the force section";
  }
  return {};
}

}  // namespace coaster::world
