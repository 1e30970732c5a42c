// One frame of the UI, in order: input, keys, menu, columns, status bar, viewport tool, notices.
#include "ui/host/host.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <variant>

#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "ui/actions/actions.h"
#include "ui/actions/command_palette.h"
#include "ui/actions/gamepad.h"
#include "ui/host/layout.h"
#include "ui/lab/force_key_editor.h"
#include "ui/lab/page_widgets.h"
#include "ui/lab/strips.h"
#include "ui/panels/panels.h"
#include "ui/panels/selected_sections.h"
#include "ui/screens/dialogs.h"
#include "ui/screens/hud.h"
#include "ui/screens/start_screen.h"
#include "ui/tools/camera_controls.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/appearance_settings.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace {

LayoutOptions wish_of(const Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  const world::Panels& shown = *settings.panels;
  // The riders' page is as high as possible, because it is read from top to bottom.
  const float usual = settings.lab->page == world::LabPage::riders ? 0.5f : 0.0f;
  return {.panels = shown.show_panels,
          .workspace = shown.workspace,
          .strip = {shown.show_laboratory, shown.laboratory_height > 0 ? shown.laboratory_height : usual},
          .parameters = ui.drawers.parameters.wanted,
          .graph = ui.drawers.graph.wanted,
          .graph_share = shown.graph_height,
          .elements = palette_size(),
          .label_width = palette_label_width(ui.scale)};
}

// Builds everything except the menu. Empty areas are skipped.
void build_areas(Ui& ui, const Layout& layout) {
  build_column(ui, PanelColumn::left, layout.left);
  build_column(ui, PanelColumn::right, layout.right);
  build_laboratory(ui, layout.strip);
  build_column(ui, PanelColumn::left, layout.parameters);
  build_palette_of_elements(ui, layout.palette, layout.grid);
  build_drawer(ui, layout.drawer);
  build_force_graph(ui, layout.graph);
  if (const float bar = ImGui::GetFrameHeight(); ui.drawers.table && layout.graph.height > bar + 1)
    build_sections_table(ui, {layout.graph.x, layout.graph.y + bar, layout.graph.width, layout.graph.height - bar});
  build_ride_bar(ui, layout.ride);
  build_status_bar(ui, layout.status);
  const world::Workspace workspace = ui.session().settings.panels->workspace;
  if (workspace == world::Workspace::build || workspace == world::Workspace::ride) draw_goals(ui, layout.scene);
}

bool text_has_keyboard() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.ActiveId != 0 && g.ActiveId == g.InputTextState.ID;
}

view::View make_view(const UiState& state, const view::Viewport& scene) {
  if (state.rig) return view::view_of(state.rig->eye, scene, state.content_scale);
  view::CameraRig rig;
  const edit::Session& s = state.session;
  view::follow(rig, {s.document, s.derived, s.motion, s.settings, true, &state.find.ground()}, 0);
  return view::view_of(rig.eye, scene, state.content_scale);
}

}  // namespace

WaitCard::WaitCard(ImGuiContext& panels, ImGuiRenderer& renderer, float scale)
    : panels_(&panels), renderer_(&renderer), scale_(scale) {
  ImGui::SetCurrentContext(panels_);
  const ImGuiIO& of_panels = ImGui::GetIO();
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 mouse = of_panels.MousePos;
  context_ = ImGui::CreateContext(of_panels.Fonts);
  ImGui::SetCurrentContext(context_);
  set_up_context();
  ImGui::GetStyle() = style;
  ImGui::GetIO().UserData = of_panels.UserData;  // the theme
  share_textures(of_panels);
  input_.feed({platform::MouseMove{mouse.x, mouse.y}}, 1, 1, false);
  ImGui::SetCurrentContext(panels_);
}

WaitCard::~WaitCard() {
  ImGui::DestroyContext(context_);
  ImGui::SetCurrentContext(panels_);
}

bool WaitCard::show(const platform::Events& events, const JobState& job, int width, int height) {
  ImGui::SetCurrentContext(context_);
  input_.feed(events, width, height, false);
  ImGui::NewFrame();
  WidgetList list;
  Entry entry;
  NumberDrag gesture;
  HoverTime rest;
  const std::function<void()> begin_gesture;
  const std::function<void(const std::string&)> warn;
  WidgetFrame ui{list, entry, gesture, rest, begin_gesture, warn, scale_};
  const view::Viewport all{0, 0, static_cast<float>(width), static_cast<float>(height)};
  if (!std::exchange(dimmed_, true))
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {all.width, all.height}, packed(0x000000, 0.4f));
  const bool cancels = draw_job(ui, all, job);
  ImGui::Render();
  if (const ImDrawData* const data = ImGui::GetDrawData()) renderer_->draw(*data, width, height);
  ImGui::SetCurrentContext(panels_);
  return cancels;
}

struct Host::Parts {
  const gfx::Gl& gl;
  PanelFonts letters;
  ImGuiContext* context = nullptr;
  std::optional<ImGuiRenderer> renderer;
  EventQueue order;
  ImGuiInput input;
  world::Theme theme = world::Theme::dark;
  WidgetList list;
  Entry entry;
  NumberDrag gesture;
  HoverTime rest;
  FieldFocusRequest wish;
  NoticeDisplay toasts;
  LabCache lab;
  Dialogs dialogs;
  StartScreen start;
  FoldingParts drawers;
  LessonGuide guide;
  KeyMap keys;
  PanelState inputs;
  std::filesystem::path file_of;  // the session's path it was taken from
  ViewportTool tool;
  FollowCamera follow_camera;
  FlyKeys fly_keys;
  Gamepad gamepad;
  CommandPalette palette;
  view::View view;
  view::Pick hovered;
  std::string dropped;      // a file or a link to open
  bool frame_next = false;  // frame the track that the last frame's commands loaded

  explicit Parts(const gfx::Gl& table) : gl(table) {
    std::vector<std::string> none;
    keys = KeyMap::make(key_rows(), {}, none);
  }
  ~Parts() {
    renderer.reset();
    if (context != nullptr) ImGui::DestroyContext(context);
  }

  void restyle(world::Theme wanted, float scale);
  void follow_session(const UiState& state);
  void settle_gesture(Ui& ui);
  void take_files(Ui& ui, const platform::Events& events);
  void take_want(Ui& ui);
  void lay_out(Ui& ui, const platform::Events& events, int width, int height);
};

void Host::Parts::restyle(world::Theme wanted, float scale) {
  const bool loaded = letters.load(scale);
  if (!loaded && wanted == theme) return;
  theme = wanted;
  apply_theme(palette_of(theme), scale);
}

void Host::Parts::follow_session(const UiState& state) {
  toasts.update(state.session, state.seconds, state.scripted, dialogs.open());
  if (state.session.file.path != file_of) {
    file_of = state.session.file.path;
    inputs.file = file_of.string();
  }
  if (gesture.open && !state.session.history.in_gesture) {  // undone, or ended by a script
    gesture = {};
    ImGui::ClearActiveID();
  }
}

// Ends the gesture of a number when its field is released or gone.
void Host::Parts::settle_gesture(Ui& ui) {
  const ImGuiID active = ImGui::GetCurrentContext()->ActiveId;
  if (gesture.open && active != gesture.id) {
    ui.emit(edit::EndGesture{});
    gesture = {};
  }
  if (entry.id != 0 && active != entry.id) entry = {};
}

void Host::Parts::take_files(Ui& ui, const platform::Events& events) {
  for (const platform::Event& event : events) {
    if (const auto* drop = std::get_if<platform::FileDrop>(&event)) dropped = drop->path;
    if (std::holds_alternative<platform::CloseRequest>(event)) dialogs.take(ui, {ScreenRequest::Kind::quit});
  }
  if (!dropped.empty()) dialogs.take(ui, {ScreenRequest::Kind::replace, edit::LoadTrack{std::exchange(dropped, {})}});
}

void Host::Parts::take_want(Ui& ui) {
  const ScreenRequest want = std::exchange(ui.want, {});
  want.kind == ScreenRequest::Kind::start_screen ? start.show() : dialogs.take(ui, want);
}

void Host::Parts::lay_out(Ui& ui, const platform::Events& events, int width, int height) {
  const edit::Session& session = ui.session();
  const Layout layout = make_layout(width, height, ui.scale, ImGui::GetFrameHeight(), wish_of(ui));
  drawers.parameters.open = layout.parameters.height > 0;
  drawers.graph.open = layout.graph.height > ImGui::GetFrameHeight() + 1;
  view = ui.out.view = make_view(ui.state, layout.scene);
  const bool framed = std::exchange(frame_next, false);
  const view::Viewport& beside = ui.out.free = beside_hints(ui, layout.scene, 300 * ui.scale);
  if (framed) ui.emit(edit::set_camera(framed_all(session, layout.scene, beside)));
  const bool typing = text_has_keyboard(), asking = dialogs.open() || start.open(), listing = input.listing();
  take_files(ui, events);
  ActionContext act{ui, tool, layout.scene, beside, hovered, palette};
  if (start.open() && !dialogs.open()) run_keys(act, events, kOnStart);
  else if (!typing && !asking && !listing)
    tool.transform().active() ? run_transform_keys(act, events) : run_keys(act, without_force_keys(ui, events));
  take_want(ui);
  fly_keys.fly(ui, events, typing || listing || asking || dialogs.open());
  gamepad.work(act, events, asking || dialogs.open());
  if (session.settings.panels->show_panels) {
    build_menu(act);
    build_areas(ui, layout);
  }
  draw_hints(ui, layout.scene);
  draw_lesson(ui, layout.scene, guide);
  const view::Viewport free = draw_score_card(ui, layout.scene);  // for hint and notice at the bottom
  ui.out.cancel_job = draw_job(ui, layout.scene, ui.state.job);
  draw_movie(ui, layout.scene);
  build_palette(act, palette);
  take_want(ui);
  if (!dialogs.open()) start.build(ui, events, static_cast<float>(width), static_cast<float>(height));
  take_want(ui);
  dialogs.build(ui, listing ? platform::Events{} : events, typing, static_cast<float>(width),
                static_cast<float>(height));
  settle_gesture(ui);
  hovered = tool.update(ui, view);
  if (hovered.kind == view::PickKind::none) hovered = ui.pointed;
  follow_camera.update(ui, view, beside, tool.dragging() || gesture.open || framed);
  if (ui.state.lesson == nullptr || tool.transform().active()) draw_foot_line(ui, tool, free);  // a lesson has its own
  draw_section_name(ui, layout.scene);
  draw_legend(ui, layout.scene);
  toasts.draw(ui, beside_hints(ui, free, 400 * ui.scale));
  for (const edit::Command& command : ui.out.commands)
    if (edit::info(command).traits.replaces) frame_next = !edit::opens_link(command), start.hide();
  if (ui.out.wants_tutorial || ui.out.recovery == RecoveryAnswer::recover || palette.open) start.hide();
}

base::Result<std::unique_ptr<Host>> Host::make(const gfx::Gl& gl) {
  auto parts = std::make_unique<Parts>(gl);
  IMGUI_CHECKVERSION();
  ImGuiContext* before = ImGui::GetCurrentContext();
  parts->context = ImGui::CreateContext();
  ImGui::SetCurrentContext(parts->context);
  set_up_context();
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  auto renderer = ImGuiRenderer::make(gl);
  if (!renderer) {
    ImGui::SetCurrentContext(before);
    return renderer.status();
  }
  parts->renderer.emplace(std::move(*renderer));
  return std::unique_ptr<Host>(new Host(std::move(parts)));
}

Host::Host(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Host::~Host() = default;

Output Host::build(const platform::Events& polled, const UiState& state, int width, int height) {
  COASTER_CHECK(width >= 1 && height >= 1, "the UI needs at least one pixel");
  Parts& p = *parts_;
  ImGui::SetCurrentContext(p.context);
  const float scale = fitted_scale(width, height, state.session.settings.look->ui_scale, state.content_scale);
  ImGui::GetIO().MouseDragThreshold = platform::kDragThreshold * state.content_scale;  // of drags in the view, too
  p.restyle(state.session.settings.look->theme, scale);
  p.follow_session(state);
  const bool field_opens = p.palette.open || p.wish.id != 0 || !p.wish.panel.empty();
  const platform::Events events = p.order.take(polled, text_has_keyboard(), p.input.clicks_wait(), field_opens);
  p.input.feed(events, width, height, text_has_keyboard(), p.start.open() && !p.dialogs.open());
  ImGui::NewFrame();
  Output out;
  p.list.clear();
  const std::function<void()> begin_gesture = [&] { out.commands.push_back(edit::Command(edit::BeginGesture{})); };
  const std::function<void(const std::string&)> warn = [&](const std::string& text) {
    p.toasts.show(edit::NoticeKind::warning, text, state.seconds);
  };
  Ui ui{
      {p.list, p.entry, p.gesture, p.rest, begin_gesture, warn, scale, {}, state.session.settings.look->units, &p.wish},
      state,
      out,
      p.lab,
      p.inputs,
      p.keys,
      p.gl.renderer,
      p.hovered,
      p.drawers};
  ui.finger = p.input.finger();
  ui.lesson_begins = p.guide.begins(state.lesson);
  ui.lesson_widget = p.guide.target ? &*p.guide.target : nullptr;
  p.lay_out(ui, events, width, height);
  p.rest.step(events, ImGui::GetIO().DeltaTime);
  ImGui::Render();
  p.list.finish();  // the order of the windows and the used ones are known now
  p.guide.follow(state.lesson, p.list.widgets());
  out.takes_text = text_has_keyboard();
  out.hovered = p.hovered;
  return out;
}

void Host::draw(int width, int height) {
  ImGui::SetCurrentContext(parts_->context);
  if (const ImDrawData* const data = ImGui::GetDrawData()) parts_->renderer->draw(*data, width, height);
}

std::unique_ptr<WaitCard> Host::make_wait_card() {
  return std::make_unique<WaitCard>(*parts_->context, *parts_->renderer, parts_->letters.scale());
}

std::vector<std::string> Host::set_keys(std::span<const exchange::KeyBinding> choices) {
  std::vector<std::string> problems;
  parts_->keys = KeyMap::make(key_rows(), choices, problems);
  return problems;
}

void Host::show_start() { parts_->start.show(); }
void Host::open(std::string path) { parts_->dropped = std::move(path); }

// ImGui stores the open headers and the scroll positions with each window.
void Host::reset_layout() {
  ImGui::SetCurrentContext(parts_->context);
  parts_->drawers = {};
  for (ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
    window->StateStorage.Clear();
    window->Scroll = {0, 0};
  }
}

const std::vector<Widget>& Host::widgets() const { return parts_->list.widgets(); }
const view::View& Host::view() const { return parts_->view; }
std::string Host::toast() const { return parts_->toasts.shown; }
bool Host::input_waits() const {
  return parts_->input.clicks_wait() || parts_->input.keys_wait() || parts_->order.waits();
}

double Host::still_for(double seconds) const {
  constexpr double kBlink = 0.1, kList = 1, kLong = 1e9;  // s
  ImGui::SetCurrentContext(parts_->context);
  if (parts_->tool.painting()) return 0;  // a brush works as long as it is held
  return std::min({parts_->toasts.still_for(seconds), text_has_keyboard() ? kBlink : kLong,
                   parts_->dialogs.open() ? kList : kLong});
}

bool Host::wants_keyboard() const {
  ImGui::SetCurrentContext(parts_->context);
  return text_has_keyboard() || parts_->palette.open || open_popups() > 0;
}

}  // namespace coaster::ui
