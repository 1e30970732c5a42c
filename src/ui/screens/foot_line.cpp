#include "ui/screens/foot_line.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "ui/widgets/theme.h"
#include "world/aids.h"

namespace coaster::ui {
namespace {

std::string foot_text(const ViewportTool& tool, const edit::Session& session, const KeyMap& keys) {
  if (tool.transform().active())
    return tool.transform().status() + "     X Y Z axis \u00B7 Shift plane \u00B7 digits \u00B7 Enter \u00B7 " +
           keys.shown("Cancel");
  if (tool.box_waits())
    return "Drag a box around knots. Shift adds, Ctrl removes, " + keys.shown("Cancel") + " cancels.";
  if (session.document.track.knots.empty()) return "Click on the ground to place the first knot";
  if (session.settings.aids->append_mode && !session.document.track.closed)
    return "Click on the ground to append knots; " + keys.shown("Append points") + " or " + keys.shown("Cancel") +
           " ends it";
  return {};
}

}  // namespace

void draw_foot_line(const Ui& ui, const ViewportTool& tool, const view::Viewport& scene) {
  const std::string hint = foot_text(tool, ui.session(), ui.keys);
  if (hint.empty()) return;
  const bool empty = ui.session().document.track.knots.empty();
  const ImVec2 size = ImGui::CalcTextSize(hint.c_str());
  // Above the notices.
  const ImVec2 at(std::floor(scene.x + (scene.width - size.x) * 0.5f),
                  std::floor(empty ? scene.y + scene.height * 0.62f : scene.y + scene.height - 5.6f * size.y));
  const ImVec2 pad(size.y * 0.9f, size.y * 0.5f);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({at.x - pad.x, at.y - pad.y}, {at.x + size.x + pad.x, at.y + size.y + pad.y},
                     packed(palette().background, 0.78f), size.y);
  list.AddText(at, packed(palette().text), hint.c_str());
}

}  // namespace coaster::ui
