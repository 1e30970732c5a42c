// Every panel, page, menu and screen, shown one after the other.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/element_rows.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {

// A stage with a challenge, a force section and an element, which shows all parts of the UI.
class AllPartsStage : public Stage {
 protected:
  void SetUp() override {
    Stage::SetUp();
    good(edit::SetStartSpeed{18});
    good(edit::AddForceSection{});
    good(edit::PlaceElement{world::usual_element(world::ElementKind::straight)});
    good(edit::StartChallenge{(std::filesystem::path(COASTER_SOURCE_DIR) / "challenges/01_first_hill.json").string()});
  }
  void good(const edit::Command& command) {
    const base::Status status = edit::apply(session_, files_, command);
    EXPECT_TRUE(status.ok()) << status.message;
  }
  template <auto Member>
  void set(world::ValueOf<Member> to) {
    good(edit::Set<Member>{to});
  }

  // Shows what lies over the view.
  virtual void over_the_view(const std::function<void(const std::string& where)>&) {}

  // Shows every panel, page and screen, one after the other.
  void visit(const std::function<void(const std::string& where)>& look) {
    const auto show = [&](const std::string& where) {
      frames(3);
      look(where);
    };
    using world::Workspace;
    for (const Workspace one : {Workspace::build, Workspace::ride, Workspace::laboratory, Workspace::all}) {
      set<&world::Panels::workspace>(one);
      const std::string where(base::name_of(one));
      good(edit::Select{});
      show(where);
      for (const auto& [kind, number] : {std::pair{world::EntityKind::knot, 2u},
                                         {world::EntityKind::segment, 1u},
                                         {world::EntityKind::section, 1u}}) {
        if (!entity(kind, number).valid()) continue;
        select(kind, number);
        show(where + " with a selection");
      }
      set<&world::EditingAids::show_element>(true);
      show(where + " with an element");
      set<&world::EditingAids::show_element>(false);
    }
    set<&world::Panels::workspace>(Workspace::laboratory);
    set<&world::Panels::show_laboratory>(true);
    for (std::size_t page = 0; page < std::size(world::kLabPages); ++page) {
      set<&world::LabView::page>(static_cast<world::LabPage>(page));
      show("page " + std::string(world::kLabPages[page].label));
    }
    set<&world::Panels::show_laboratory>(false);
    set<&world::Panels::workspace>(Workspace::all);
    const query::LessonCard card{"Click Close, below the track's other commands.", "Shape/Close", 3, 9};
    lesson_ = &card;
    frames(12);
    show("lesson");
    lesson_ = nullptr;
    over_the_view(show);
    user_.emplace();
    host_->show_start();
    show("start screen");
    key(platform::Key::escape);
    frames(2);
    using platform::Key;
    struct Dialog {
      const char* name;
      Key key;
      platform::Modifiers with;
    };
    for (const Dialog& dialog : {Dialog{"Open", Key::o, {.ctrl = true}},
                                 {"Save as", Key::s, {.shift = true, .ctrl = true}},
                                 {"Challenges", Key::h, {.ctrl = true}},
                                 {"Settings", Key::comma, {.ctrl = true}},
                                 {"Palette", Key::p, {.ctrl = true}}}) {
      session_.file.saved_hash = edit::SessionFindings(session_).document_hash();
      const std::size_t before = host_->widgets().size();
      key(dialog.key, dialog.with);
      show(dialog.name);
      EXPECT_GT(host_->widgets().size(), before) << dialog.name;
      key(Key::escape);
      frames(3);
    }
    std::vector<std::string> menus;
    for (const Widget& w : host_->widgets())
      if (w.kind == "menu" && w.path.starts_with("Menu/") && w.path.find('/', 5) == std::string::npos)
        menus.push_back(w.path);
    EXPECT_GT(menus.size(), 3u);
    for (const std::string& menu : menus) {
      click(menu);
      show(menu);
      key(Key::escape);
      frames(3);
    }
  }
};

}  // namespace coaster::ui
