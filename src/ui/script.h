// Script: what a test tells the real window to do, one command a line, and the words it is written in.
//
//   open PATH                      drop PATH                    sample NAME [PANELS]
//   wait_loaded S   wait_solved S  wait_solving S               wait_iterates N S     wait_frames N
//   click PATH      ctrl_click PATH   shift_click PATH          double_click PATH
//   hover PATH      wheel PATH NOTCHES
//   drag PATH FRACTION             press PATH | move PATH FRACTION | release          drag_by PATH DX DY
//   click_edge N|any   hover_edge N|any   context_edge N|any   click_model FX FY     orbit DX DY   pan DX DY
//   zoom NOTCHES       click_panel N|any [MODS]                click_corner N|any [MODS]
//   drag_pin N DX DY   drag_box FX FY FX FY [MODS]             hover_model FX FY
//   click_region N|any|beside [MODS]                           hover_region N|any|beside
//   click_border N|any M|beside                                drag_region N|any M|beside
//   key Ctrl+Z         type TEXT          export PATH          screenshot FILE.png
//   expect KEY OP VALUE                   remember KEY NAME    print [KEY ...]       dump_ui
//   clear_timings      wait_export S
//
// The region nearest to the middle of the input's view: any; one that lies beside it: beside. The commands
// leave their numbers as $region and $neighbour.
// The edge nearest to the middle of the view that can be flipped: any; that a finding flags: flagged; that
// cannot be flipped: stuck. All three commands on edges know these, and leave its number as $edge.
// wait_export: until what the export dialog wants is prepared, or cannot be, and nothing is being written.
// MODS are keys that are held, like "Shift" or "Ctrl+Alt".
// PATH of a control is "Panel/name" in quotes where it has spaces; FRACTION is of a slider's travel. OP is
// one of == != < <= > >= contains. VALUE may be $NAME, a value that was remembered. # begins a comment.
// Threads: plain values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace planewright::ui {

struct ScriptCommand {
  int line = 0;  // 1-based
  std::vector<std::string> words;
};

struct Script {
  std::string name;  // for messages
  std::vector<ScriptCommand> commands;
};

// Fails with ErrorCode::Usage, naming the line: an unknown command, too few or too many words, an open quote.
Result<Script> parse_script(const std::string& text, const std::string& name);
Result<Script> load_script(const std::filesystem::path& path);

// The number that a word is, the whole of it; nothing if it is none.
std::optional<double> number_in(const std::string& word);

}  // namespace planewright::ui
