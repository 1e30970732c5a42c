// Readers of single statements for the table in lines.cpp: expect, input, ui.* and aim.*. Private to the grammar.
#pragma once

#include "base/words.h"
#include "script/statements.h"

namespace coaster::script {

using base::Words;

bool parse_snap(Words& words, Action& action);  // lines_output.cpp
bool parse_shot(Words& words, Action& action);
bool parse_sheet(Words& words, Action& action);
bool parse_dump(Words& words, Action& action);
bool parse_log(Words& words, Action& action);
bool parse_movie_start(Words& words, Action& action);
bool parse_movie_stop(Words& words, Action& action);

bool parse_expect(Words& words, Action& action);  // lines_expect.cpp

bool parse_lesson(Words& words, Action& action);  // opens a block; lines_expect.cpp

bool parse_key(Words& words, Action& action);  // lines_input.cpp
bool parse_text(Words& words, Action& action);
bool parse_wheel(Words& words, Action& action);
bool parse_drop(Words& words, Action& action);
bool parse_focus(Words& words, Action& action);
bool parse_pad(Words& words, Action& action);
bool parse_resize(Words& words, Action& action);
bool parse_minimise(Words& words, Action& action);
bool parse_raw_move(Words& words, Action& action);
bool parse_raw_press(Words& words, Action& action);
bool parse_raw_release(Words& words, Action& action);
bool parse_raw_key(Words& words, Action& action);

bool parse_ui_click(Words& words, Action& action);  // lines_ui.cpp
bool parse_ui_doubleclick(Words& words, Action& action);
bool parse_ui_hover(Words& words, Action& action);
bool parse_ui_check(Words& words, Action& action);
bool parse_ui_type(Words& words, Action& action);
bool parse_ui_drag(Words& words, Action& action);
bool parse_ui_open(Words& words, Action& action);
bool parse_ui_close(Words& words, Action& action);
bool parse_ui_menu(Words& words, Action& action);
bool parse_ui_scroll(Words& words, Action& action);

bool parse_aim_click(Words& words, Action& action);  // lines_aim.cpp
bool parse_aim_doubleclick(Words& words, Action& action);
bool parse_aim_hover(Words& words, Action& action);
bool parse_aim_drag(Words& words, Action& action);

}  // namespace coaster::script
