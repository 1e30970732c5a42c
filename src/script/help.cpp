// The text of --help-script.
#include "script/help.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "edit/commands/codec.h"
#include "query/query.h"

namespace coaster::script {
namespace {

struct HelpRow {
  std::string_view usage, text;
};

constexpr std::array kSession{
    HelpRow{"coaster-script 1", "The first line of every script."},
    HelpRow{"env [size WxH] [seed N] [scale X] [msaa N]",
            "Picture size (640x360), seed, scale of the panels, samples a pixel (0)."},
    HelpRow{"env home \"$OUT/FOLDER\"",
            "Keeps settings and autosaves there: an empty folder at first, later as though the program had crashed and "
            "were started again."},
    HelpRow{"include \"FILE\"", "The statements of another script."},
    HelpRow{"repeat N ... end", "The lines up to end, N times."},
    HelpRow{"gesture ... end", "The commands up to end are one step of undo."},
    HelpRow{"lesson \"TEXT\" [at \"WIDGET\"] until CONDITION ... end",
            "A player does what the text says; without one the lines up to end do it."},
    HelpRow{"frames N", "Draws N frames of 2 ticks (1/60 s) each."},
    HelpRow{"ticks N", "Advances by N ticks of 1/120 s without drawing."},
    HelpRow{"wait QUERY [ARGUMENT] OP VALUE [+-TOLERANCE] [max N ticks|frames|seconds]",
            "Advances until it is so; exit code 6 when it is not in time."},
    HelpRow{"camera [target X Y Z] [yaw A] [pitch B] [distance D]", "Looks so; what is not named stays."},
    HelpRow{"camera all|selection", "Frames the whole track or what is selected."},
    HelpRow{"camera orbit|ride|chase|fly", "The same as camera_mode."},
};
constexpr std::array kInput{
    HelpRow{"ui.click|doubleclick|hover \"PATH\"", "On the one widget with this label path."},
    HelpRow{"ui.check \"PATH\" on|off", "Clicks when the box shows the other."},
    HelpRow{"ui.type \"PATH\" \"TEXT\"", "Replaces a field's text and presses Enter."},
    HelpRow{"ui.drag \"PATH\" by N px", "Drags sideways from the widget's middle."},
    HelpRow{"ui.drag \"PATH\" to VALUE", "Drags a slider until it shows the value."},
    HelpRow{"ui.open|close \"PATH\"", "Opens or closes a header; opens a combo or menu."},
    HelpRow{"ui.menu \"MENU/ITEM\"", "Opens the menu and clicks the item."},
    HelpRow{"ui.scroll \"PANEL\" N", "Turns the wheel over a panel; positive: down."},
    HelpRow{"aim.click|doubleclick|hover [+shift] [+ctrl] [+alt] TARGET",
            "TARGET: @k3 @k3.in @k3.out @s2:0.4 @c1, ground X Y Z, world X Y Z."},
    HelpRow{"aim.drag [+shift] [+ctrl] [+alt] TARGET by X Y Z",
            "Presses, moves and releases in the viewport, by a distance (m)."},
    HelpRow{"aim.drag [+shift] [+ctrl] [+alt] TARGET to X Y Z|TARGET", "The same, to a place."},
    HelpRow{"key CHORD", "Presses and releases a key: F, Escape, Ctrl+Z."},
    HelpRow{"text \"TEXT\"", "Types a text."},
    HelpRow{"wheel N [at X Y]", "Turns the wheel; positive: up."},
    HelpRow{"drop \"FILE\"", "Drops a file on the window."},
    HelpRow{"pad [left X Y] [right X Y] [triggers L R]",
            "Holds a gamepad's sticks (-1..1, right and down positive) and triggers (0..1) so; what is not named is "
            "let go."},
    HelpRow{"pad rest | a | b | x | y", "Lets go of all, or presses and releases a button."},
    HelpRow{"focus on|off", "The window gets or loses the keyboard."},
    HelpRow{"resize WxH", "Changes the picture's size."},
    HelpRow{"minimise", "Hides the window: size 0, nothing is drawn."},
    HelpRow{"raw.move X Y", "Moves the cursor to a pixel."},
    HelpRow{"raw.press|release left|right|middle", "Presses or releases a button."},
    HelpRow{"raw.key CHORD down|up", "Presses or releases a key."},
};
constexpr std::array kOutput{
    HelpRow{"expect QUERY [ARGUMENT] OP VALUE [+-TOLERANCE]", "OP: == != < <= > >= and ~ (contains)."},
    HelpRow{"expect [not] visible|enabled \"PATH\"", "A widget's state."},
    HelpRow{"expect file \"FILE\" exists | same \"FILE\"", "A file is there, or is the same byte by byte."},
    HelpRow{"expect error STATEMENT [~ \"TEXT\"]", "The statement must fail, and say TEXT."},
    HelpRow{"snap \"NAME\"", "Compares the picture with golden/NAME.png."},
    HelpRow{"shot \"$OUT/FILE.png\"", "Writes the picture."},
    HelpRow{"sheet \"$OUT/FILE.png\" [columns N] [half] \"PICTURE.png\" ...",
            "Puts pictures side by side into one, each at half its size if asked to."},
    HelpRow{"movie.start \"$OUT/FOLDER\" [fps N] [gif]",
            "Pictures of all ticks from here on, N a second (30): numbered PNG files, and movie.mp4 (movie.gif) where "
            "ffmpeg is installed."},
    HelpRow{"movie.stop", "No more pictures; waits for the movie's file."},
    HelpRow{"dump \"NAME\"", "Writes picture, widgets, values and document to $OUT/NAME.*."},
    HelpRow{"log QUERY|\"TEXT\" ...", "Prints values and texts to stdout."},
    HelpRow{"fault io.open|read|write|fsync|rename|close fail N", "The Nth such operation from now on fails."},
    HelpRow{"fault import slow N",
            "The next file imported by hand takes N frames longer: time to see its bar, and to cancel."},
};

template <class Rows>
void section(std::string& out, std::string_view title, const Rows& rows) {
  out += std::string(title) + "\n";
  for (const HelpRow& row : rows) out += fmt::format("  {}\n      {}\n", row.usage, row.text);
  out += "\n";
}

}  // namespace

std::string help() {
  std::string out = "Coaster scripts, version 1: one statement a line; # starts a comment.\n\n";
  section(out, "Session", kSession);
  section(out, "Input", kInput);
  section(out, "Checks and output", kOutput);
  out += "Commands\n";
  for (const edit::CommandHelp& row : edit::command_table())
    out += fmt::format("  {}\n      {}\n", row.usage, row.info.help);
  out += "\nQueries\n";
  for (const query::Query& query : query::queries()) {
    out += fmt::format("  {}{}", query.name, query.argument.empty() ? "" : " " + std::string(query.argument));
    if (!query.unit.empty()) out += fmt::format(" ({})", query.unit);
    out += fmt::format("\n      {}\n", query.text);
  }
  return out +
         "\nExit codes: 0 ok, 1 an expectation failed, 2 usage or script error, 3 bad file, 4 no graphics, 5 input or "
         "output, 6 timeout.\n";
}

}  // namespace coaster::script
