// AppState: everything that the window is about, without a window: the document, the solve session, what of
// it is shown, what is selected, and the messages to the designer. No OpenGL, no Dear ImGui; a test can drive
// it.
//
// A frame of the window calls update() once: it takes what the workers have ready, drops what is stale, and
// starts the solve that a change asks for. Nothing here waits for a worker.
//
// Threads: the window's. Units: model units; scene coordinates are model coordinates minus scene_origin().
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/edit/document.h"
#include "core/design/solve_session.h"
#include "ui/background_task.h"
#include "ui/frame_timings.h"
#include "ui/mesh_view.h"
#include "ui/view_preparer.h"

namespace planewright::ui {

using Clock = std::chrono::steady_clock;

enum class ColourMap { None, Planarity, Displacement };
const char* name(ColourMap map);  // "none", "planarity", "displacement"

// What the designer chose to see.
struct ViewOptions {
  bool ghost = true;
  bool markers = true;
  bool lock_range = false;  // keep the colour map's range as it is
  ColourMap colours = ColourMap::None;

  bool operator==(const ViewOptions&) const = default;
};

struct Message {
  enum class Kind { Info, Warning, Error };
  std::uint64_t id = 0;
  Kind kind = Kind::Info;
  std::string what, where, remedy;
  Clock::time_point posted;
};

class AppState {
 public:
  // `wake`: called from workers when there is something to take; may be empty.
  explicit AppState(std::function<void()> wake = {});
  ~AppState();
  AppState(const AppState&) = delete;
  AppState& operator=(const AppState&) = delete;

  // --- Files. Read and written off the window's thread; errors become messages and lose nothing.
  void open_file(const std::filesystem::path& path);
  void open_sample(std::string sample, int panels = 0);
  bool loading() const { return loader_.running(); }
  const std::string& loading_name() const { return loading_name_; }
  bool can_export() const;
  void export_panels(const std::filesystem::path& path);
  bool exporting() const { return exporter_.running(); }
  // Grows with every design that was opened: the viewport fits its camera to a new one.
  std::uint64_t opened_count() const { return opened_count_; }

  // --- Edits. Each re-solves (or, without auto-solve, waits for the designer to say so).
  const Document& document() const { return document_; }
  void change_settings(LayerSettings settings, std::string what, std::string merge_key = {});
  void end_merge();
  bool flip_edge(int edge);  // a refusal becomes a message
  void undo();
  void redo();

  // --- Solving.
  enum class Start { Warm, Afresh };  // from the newest state, or from the builder's own
  void solve(Start start = Start::Warm);
  void stop();
  bool solving() const { return solve_wanted_ || session_.running(); }
  bool up_to_date() const { return solved_revision_ == document_.revision(); }
  void set_auto_solve(bool on) { auto_solve_ = on; }
  bool auto_solve() const { return auto_solve_; }

  // Takes what is ready, starts what is due. True if anything that is shown has changed.
  bool update(Clock::time_point now);
  // When update() has something to do even if no worker calls; nothing if it can sleep.
  std::optional<Clock::time_point> next_deadline() const;

  // --- What is shown.
  Vector3d scene_origin() const { return scene_origin_; }
  const std::shared_ptr<const MeshView>& mesh_view() const { return mesh_view_; }
  // What is drawn of it: null until a new design's is ready; after an edit the one before, for a moment.
  const std::shared_ptr<const PreparedGhost>& ghost() const { return ghost_; }
  // The newest prepared state, or null before the first iterate of a design. While a newer solve has not
  // delivered yet, this is the last good state of the one before.
  const std::shared_ptr<const PreparedView>& shown() const { return shown_; }
  // Scalars of the newest solve that has delivered some.
  const std::vector<Iteration>& history() const { return history_; }
  // How the newest finished solve ended; null while a solve of another state is under way for the first time.
  const SolveReport* report() const { return report_ ? &*report_ : nullptr; }
  // What each energy adds to the objective: of the newest step while a solve runs, else of the report.
  const std::vector<SolveReport::Energy>& energies() const { return energies_; }
  // All shown work belongs to the newest change, and nothing is under way.
  bool settled() const;
  double milliseconds_per_step() const;  // mean over the history; 0 if unknown
  // Different states of the running (or last) solve that were shown before it ended.
  int iterates_before_end() const { return iterates_before_end_; }
  std::uint64_t ticket() const { return session_.current_ticket(); }
  // The upper end of the colour map's range (0 without one): grows during a solve, starts anew with the next
  // design, and stands still when locked.
  double colour_range() const;
  double planarity_tolerance() const;  // model units: below it a panel counts as planar

  ViewOptions view_options;
  std::optional<int> selected_panel;
  std::optional<int> selected_point;

  // --- Messages.
  const std::vector<Message>& messages() const { return messages_; }
  void post(Message::Kind kind, std::string what, std::string where = {}, std::string remedy = {});
  void post(const Error& error);
  void dismiss(std::uint64_t message);
  std::uint64_t messages_posted() const { return next_message_ - 1; }

  FrameTimings timings;

 private:
  struct Loaded {
    CheckedMesh mesh;
    std::string name;
  };

  void begin_load(std::string name, std::function<Result<Loaded>()> load);
  void adopt(Loaded loaded);
  void document_changed();
  void refresh_mesh_view();
  bool drain();
  void take_energies();
  void take_outcome(SolveOutcome outcome);
  bool show_prepared();
  bool view_range_locked() const;
  bool may_start(Clock::time_point now) const;
  void start_solve(Clock::time_point now);

  std::function<void()> wake_;
  Document document_;
  BackgroundTask<Result<Loaded>> loader_;
  BackgroundTask<Result<std::string>> exporter_;
  std::string loading_name_;
  std::function<void()> load_next_;  // asked for while another was loading
  std::uint64_t opened_count_ = 0;

  Vector3d scene_origin_ = Vector3d::Zero();
  std::shared_ptr<const MeshView> mesh_view_;
  std::shared_ptr<const PreparedGhost> ghost_;

  std::shared_ptr<const Iterate> newest_;  // the newest state that any solve of this design delivered
  std::shared_ptr<const PreparedView> shown_;
  std::vector<Iteration> history_;
  std::uint64_t history_ticket_ = 0;
  std::optional<SolveReport> report_;
  std::vector<SolveReport::Energy> energies_;
  std::uint64_t finished_ticket_ = 0;  // its outcome was taken
  bool outcome_failed_ = false;        // that outcome had no state to show
  int iterates_before_end_ = 0;
  std::uint64_t last_fingerprint_ = 0;
  double planarity_range_ = 0.0, displacement_range_ = 0.0;

  bool auto_solve_ = true;
  bool solve_wanted_ = false;
  bool start_afresh_ = false;
  bool merging_ = false;  // a slider is being dragged
  std::uint64_t solved_revision_ = 0;
  std::uint64_t ignored_ticket_ = 0;  // tickets up to here belong to designs that were closed
  Clock::time_point last_start_{};
  std::vector<Iteration> drained_;

  std::vector<Message> messages_;
  std::uint64_t next_message_ = 1;

  // Last members: their threads end before what they refer to goes.
  ViewPreparer preparer_;
  SolveSession session_;
};

}  // namespace planewright::ui
