// The text of --help-script.
#include "script/help.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/exit_codes.h"
#include "edit/commands/codec.h"
#include "query/query.h"

namespace coaster::script {
namespace {

struct HelpRow {
  std::string_view usage, text;
};

constexpr std::array kSession{
    HelpRow{"coaster-script 1", "The first line of every script."},
    HelpRow{"env [size WxH] [seed N] [scale X] [density X] [msaa N]",
            "Sets picture size (640x360), seed, scale of the panels (0.75..3), pixels per point (0.5..4), samples per "
            "pixel (0)."},
    HelpRow{"env home \"$OUT/FOLDER\"",
            "Keeps settings and autosaves in that folder. The first line starts with an empty folder; a later one acts "
            "like a restart after a crash."},
    HelpRow{"include \"FILE\"", "Runs another script's statements."},
    HelpRow{"repeat N ... end", "Runs the lines up to end N times."},
    HelpRow{"gesture ... end", "Makes the commands up to end one undo step."},
    HelpRow{"lesson \"TEXT\" [at \"WIDGET\"] until CONDITION ... end",
            "Shows the text and waits until the player has done it; without a player, runs the lines up to end."},
    HelpRow{"frames N", "Draws N frames of 2 ticks (1/60 s) each."},
    HelpRow{"ticks N", "Advances by N ticks of 1/120 s without drawing."},
    HelpRow{"wait QUERY [ARGUMENT] OP VALUE [+-TOLERANCE] [max N ticks|frames|seconds]",
            "Advances until the condition holds; exit code 6 on timeout."},
    HelpRow{"camera [target X Y Z] [yaw A] [pitch B] [distance D]", "Sets the camera; values that are not given stay."},
    HelpRow{"camera all|selection", "Frames the whole track or the selection."},
    HelpRow{"camera orbit|ride|chase|fly", "The same as camera_mode."},
};
constexpr std::array kInput{
    HelpRow{"ui.click|doubleclick|hover \"PATH\"", "Clicks or hovers the widget with this label path."},
    HelpRow{"ui.check \"PATH\" on|off", "Clicks if the box is in the other state."},
    HelpRow{"ui.type \"PATH\" \"TEXT\"", "Replaces a field's text and presses Enter."},
    HelpRow{"ui.drag \"PATH\" by N px", "Drags sideways from the widget's middle."},
    HelpRow{"ui.drag \"PATH\" to VALUE", "Drags a slider until it shows the value."},
    HelpRow{"ui.open|close \"PATH\"", "Opens or closes a header; opens a combo or menu."},
    HelpRow{"ui.menu \"MENU/ITEM\"", "Opens the menu and clicks the item."},
    HelpRow{"ui.scroll \"PANEL\" N", "Turns the wheel over a panel; positive scrolls down."},
    HelpRow{
        "aim.click|doubleclick|hover [+shift] [+ctrl] [+alt] TARGET",
        "TARGET: @k3 @k3.in @k3.out @k3.spin @s2:0.4 @c1 @q2 @q2.turn @q2.bank gizmo.x gizmo.xz, ground X Y Z, world X "
        "Y Z."},
    HelpRow{"aim.drag [+shift] [+ctrl] [+alt] TARGET by X Y Z",
            "Presses, moves by an offset (m) and releases in the viewport."},
    HelpRow{"aim.drag [+shift] [+ctrl] [+alt] TARGET to X Y Z|TARGET", "The same, to a position."},
    HelpRow{"key CHORD", "Presses and releases a key: F, Escape, Ctrl+Z."},
    HelpRow{"text \"TEXT\"", "Types a text."},
    HelpRow{"wheel N [at X Y]", "Turns the wheel; positive turns up."},
    HelpRow{"drop \"FILE\"", "Drops a file on the window."},
    HelpRow{"pad [left X Y] [right X Y] [triggers L R]",
            "Holds a gamepad's sticks (-1..1, right and down positive) and triggers (0..1); releases those that are "
            "not named."},
    HelpRow{"pad rest | a | b | x | y", "Releases everything, or presses and releases a button."},
    HelpRow{"focus on|off", "Gives the window keyboard focus or takes it away."},
    HelpRow{"resize WxH", "Changes the picture's size."},
    HelpRow{"minimise", "Minimises the window: size 0, nothing is drawn."},
    HelpRow{"raw.move X Y", "Moves the cursor to a pixel."},
    HelpRow{"raw.press|release left|right|middle", "Presses or releases a button."},
    HelpRow{"raw.key CHORD down|up", "Presses or releases a key."},
};
constexpr std::array kOutput{
    HelpRow{"expect QUERY [ARGUMENT] OP VALUE [+-TOLERANCE]",
            "Checks a value. OP: == != < <= > >= and ~ (contains). A value that is none meets only == none."},
    HelpRow{"expect [not] visible|enabled \"PATH\"", "Checks a widget's state."},
    HelpRow{"expect file \"FILE\" exists | same \"FILE\"",
            "Checks that a file exists, or equals another byte by byte."},
    HelpRow{"expect error STATEMENT [~ \"TEXT\"]",
            "Checks that the statement, written correctly, fails with TEXT in its message."},
    HelpRow{"snap \"NAME\"", "Compares the picture with golden/NAME.png."},
    HelpRow{"shot \"$OUT/FILE.png\"", "Writes the picture."},
    HelpRow{"sheet \"$OUT/FILE.png\" [columns N] [half] \"PICTURE.png\" ...",
            "Combines pictures into one, with half at half size."},
    HelpRow{"movie.start \"$OUT/FOLDER\" [fps N] [gif]",
            "Records all ticks from here on, N pictures a second (30): numbered PNG files, and movie.mp4 (movie.gif) "
            "if ffmpeg is installed."},
    HelpRow{"movie.stop", "Stops recording and waits for the movie file."},
    HelpRow{"dump \"NAME\"", "Writes picture, widgets, values and document to $OUT/NAME.*."},
    HelpRow{"log QUERY|\"TEXT\" ...", "Prints values and texts to stdout."},
    HelpRow{"needs vertex_shader|geometry_shader|tessellation_shader",
            "Ends the script as skipped, with exit code 77, where the driver cannot evaluate there."},
    HelpRow{"fault io.open|read|write|fsync|rename|close fail N", "Makes the Nth such operation from now on fail."},
    HelpRow{"fault crash input|job|panels|command|ticks|findings|drawing|keeping "
            "[access|check|exception|stack|memory]",
            "Crashes the program the next time that it comes to that place."},
    HelpRow{
        "fault import slow N",
        "Makes the next import, search or change of a circuit by hand take N frames longer, time to see its progress "
        "bar or cancel."},
};

template <class Rows>
void section(std::string& out, std::string_view title, const Rows& rows) {
  out += fmt::format("{}\n", title);
  for (const HelpRow& row : rows) out += fmt::format("  {}\n      {}\n", row.usage, row.text);
  out += "\n";
}

}  // namespace

std::string help() {
  std::string out = "Coaster scripts, version 1: one statement per line; # starts a comment.\n\n";
  section(out, "Session", kSession);
  section(out, "Input", kInput);
  section(out, "Checks and output", kOutput);
  out += "Commands\n";
  for (const edit::CommandHelp& row : edit::command_table())
    out += fmt::format("  {}\n      {}\n", row.usage, row.info.help);
  out += "\nQueries\n";
  for (const query::Query& query : query::queries()) {
    const std::string unit = query.unit.empty() ? "" : fmt::format(" ({})", query.unit);
    out += fmt::format("  {}{}{}{}{}\n      {}\n", query.name, query.argument.empty() ? "" : " ",
                       usage_of(query.argument), unit, query.values.may_be_none ? " or none" : "", query.text);
  }
  return out + "\n" + base::exit_codes_sentence() + "\n";
}

}  // namespace coaster::script
