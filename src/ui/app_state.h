// AppState: everything that the window is about, without a window: the document, the solve session, what of
// it is shown, what is selected, and the messages to the designer. No OpenGL, no Dear ImGui; a test can drive
// it.
//
// Layers share one solver: a change to the active layer is solved at once; the others follow one after
// another when what they were solved from (mesh, settings, selections, reference, the layer they are to be
// coplanar with) is another one now. Each keeps its own newest state, report and view.
//
// A frame of the window calls update() once: it takes what the workers have ready, drops what is stale, and
// starts the solve that a change asks for. Nothing here waits for a worker.
//
// Threads: the window's. Units: model units; scene coordinates are model coordinates minus scene_origin().
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/design/cluster_report.h"
#include "core/design/solve_session.h"
#include "core/edit/document.h"
#include "core/edit/select.h"
#include "ui/advice_task.h"
#include "ui/background_task.h"
#include "ui/export_work.h"
#include "ui/failure_list.h"
#include "ui/finding_list.h"
#include "ui/frame_timings.h"
#include "ui/layer_run.h"
#include "ui/look_at.h"
#include "ui/mesh_view.h"
#include "ui/prepared_workshop.h"
#include "ui/region_view.h"
#include "ui/suggestion_list.h"
#include "ui/view_options.h"
#include "ui/view_preparer.h"
#include "ui/workshop_watch.h"

namespace planewright {
struct ReadProject;
}

namespace planewright::ui {

using Clock = std::chrono::steady_clock;

struct Message {
  enum class Kind { Info, Refused, Warning, Error };  // the first two go by themselves
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
  void open_file(const std::filesystem::path& path);  // a mesh or a project
  void open_sample(std::string sample, int panels = 0);
  bool loading() const { return loader_.running(); }
  const std::string& loading_name() const { return loading_name_; }
  // All of the design with its solved panels, and from then on its file; see project_file.h.
  void save_project(const std::filesystem::path& path);
  bool saving() const { return saver_.running(); }
  const std::filesystem::path& project_path() const { return project_path_; }  // empty: never saved
  bool modified() const;      // not as it was opened or saved
  std::string title() const;  // the project's file, or the name of the mesh
  bool can_export() const;
  void export_panels(const std::filesystem::path& path);
  bool exporting() const { return exporter_.running(); }
  // Grows with every design that was opened: the viewport fits its camera to a new one.
  std::uint64_t opened_count() const { return opened_count_; }

  // --- Edits. Each re-solves (or, without auto-solve, waits for the designer to say so).
  const Document& document() const { return document_; }
  void change_settings(LayerSettings settings, std::string what, std::string merge_key = {});
  void change_design(Design design, std::string what, std::string merge_key = {});
  void end_merge();
  // A refusal becomes a message; so does what goes with elements that are gone.
  bool edit_mesh(const MeshEdit& edit, std::string merge_key = {});
  bool edit_mesh(const std::vector<MeshEdit>& edits, std::string what, std::string merge_key = {});
  // Panels that the moment had are shown at once, and solved again only if they were of another design.
  void undo() { go_to(document_.steps_done() - 1); }
  void redo() { go_to(document_.steps_done() + 1); }
  void go_to(int steps);  // of the document's history

  // --- Layers. The active one is what edits, picking, findings and colours are about.
  int layer_count() const { return static_cast<int>(document_.design().layers.size()); }
  int active_layer() const { return document_.active_layer(); }
  // The active layer's panels are as a project had them.
  bool shows_saved() const { return run(active_layer()).saved; }
  void set_active_layer(int layer);
  void add_layer();  // and makes it the active one; so does the next
  void duplicate_layer(int layer);
  void remove_layer(int layer);  // the last one stays
  void change_layer(int layer, Layer changed, std::string what, std::string merge_key = {});
  LayerStatus layer_status(int layer) const;
  // Demands that the layer's newest report finds violated, crossings included.
  int unmet_demands(int layer) const;
  const std::shared_ptr<const PreparedView>& shown(int layer) const { return run(layer).shown; }
  const SolveReport* report(int layer) const { return run(layer).report ? &*run(layer).report : nullptr; }
  std::optional<int> solving_layer() const;  // that the solver works on
  double mean_edge() const;                  // of the shown panels, else of the mesh; 0 without one

  // --- Clusters: the regions that panels are made of in mode Cluster. They are made and changed in the
  // background; what came of it is a step of undo. A design that comes into the mode without any is given
  // some.
  const SharedClusters& clusters() const { return document_.clusters(); }
  bool clustering() const {
    return cluster_task_.running() || !cluster_wishes_.empty() || stroke_.has_value();
  }
  bool busy() const { return solving() || clustering(); }  // what stop() ends
  // What was asked for last, whatever came of it; else what the clusters were made with.
  ClusterOptions cluster_options() const;
  // Why that came to nothing; until the next wish.
  const std::optional<Error>& cluster_error() const { return cluster_error_; }
  int fewest_regions() const;  // one for each separate part of the mesh
  // Goes on from the present regions, so that a drag shows each value; with a target, or `anew`, from seeds.
  void set_cluster_options(const ClusterOptions& options, std::string what, std::string merge_key = {},
                           bool anew = false);
  void cluster_anew();
  // Refusals become messages.
  void merge_regions(int a, int b);
  void split_region(int region);
  // One stroke: faces go over to the region of face `from`, all as one step.
  void begin_painting(int from);
  void paint(const std::vector<int>& faces);
  void end_painting();
  std::optional<int> painting_region() const;
  // The input as it is drawn: of the present clusters, or for a moment of those before. Null: there are none.
  const std::shared_ptr<const RegionView>& region_view() const { return region_view_; }
  // What is seen now: Panels in every other mode.
  ClusterSight cluster_sight() const;
  // Regions all of whose faces are selected, ascending.
  const std::vector<int>& selected_regions() const;
  void select_region(int region, Combine how);
  // Selects it, and asks the viewport to go there.
  void show_region(int region);
  // Of the panels that are shown; null until it is known.
  std::shared_ptr<const ClusterReport> cluster_report() const;
  double milliseconds_per_clustering() const { return clustering_ms_; }  // the newest

  // --- Selecting: elements of the mesh, as core/edit/select.h names them; and what was pointed at last.
  const Selection& selection() const { return selection_; }
  std::uint64_t selection_changes() const { return selection_changes_; }
  void select(Selection selection, Combine how);
  void select_panel(int panel, Combine how);  // of the shown panels
  void select_point(int point, Combine how);
  void clear_selection();
  // The shown panels can be of the mesh before an edit. What they name as the present mesh's elements, and
  // the other way round; what is not there is left out.
  Selection of_present(Selection shown_names) const;
  Selection of_shown(Selection names) const;
  // Selects what an element of the shown panels is, and asks the viewport to go there.
  void show_element(const ElementRef& element);
  std::optional<LookAt> take_look_at() { return std::exchange(look_at_, std::nullopt); }
  // The selection under a name, as a step of undo; empty: a new name. Nothing selected: a message.
  void store_selection(std::string name = {});
  bool rename_selection(const std::string& from, const std::string& to);  // a refusal becomes a message
  void remove_selection(const std::string& name);

  // --- Findings: bad places of the panels that are shown of the active layer.
  // Null until they are known of the very state that is shown.
  std::shared_ptr<const PreparedFindings> findings() const;
  // Those of kinds that are not hidden, and the edges of the present mesh that they flag.
  const FindingList& finding_list() const;
  // The row of the list that the designer has gone to. Stays with its place when newer findings come.
  std::optional<int> current_finding() const;
  // Selects what the finding of the list is about, and asks the viewport to go there.
  void show_finding(int row);
  // The next (1) or previous (-1) of the list.
  void walk_findings(int by);
  // Which kinds are looked for, and from which measure on; what is shown is looked through anew.
  const FindingSettings& finding_settings() const { return finding_settings_; }
  void set_finding_settings(const FindingSettings& settings);

  // --- Workshop: what the panels that are shown of the active layer are to a workshop. Made in the
  // background while something of it is in sight; during a solve of states on the way, too.
  const std::string& unit() const;              // of the model's coordinates: "m"
  LengthUnit default_unit = LengthUnit::Metre;  // of the first design that is opened
  const WorkshopContract& contract() const { return document_.contract(); }
  void change_contract(WorkshopContract changed, std::string what, std::string merge_key = {});
  // The tolerance sheet as a file of its own; loading is a step of undo.
  void load_tolerances(const std::filesystem::path& path);
  void save_tolerances(const std::filesystem::path& path);
  bool workshop_in_sight = false;  // the window says each frame whether it is
  // Of the panels that are shown, perhaps of a state shortly before; null until it is known.
  std::shared_ptr<const PreparedWorkshop> workshop() const;
  bool workshop_fits() const;  // it is of the very state that is shown, and of the present contract
  // Why the newest panels can be nothing to a workshop.
  const std::optional<Error>& workshop_error() const { return workshop_watch_.error(); }
  // Names that have gone to the workshop stay with the active layer's panels, or those of another.
  void keep_names(const WorkshopModel& model) { keep_names(model, active_layer()); }
  void keep_names(const WorkshopModel& model, int layer);
  // How many names the active layer's panels have been given so; and gives them up.
  int kept_names() const;
  void forget_names();
  // Selects a panel that is shown, and asks the viewport to go there.
  void show_panel(int panel);
  // What fails the tolerance sheet, of kinds that are not hidden.
  const FailureList& failure_list() const;
  // The row that the designer has gone to. Stays with its place while newer verdicts come.
  std::optional<int> current_failure() const;
  // Selects the panel, and asks the viewport to go to the place.
  void show_failure(int row);
  void walk_failures(int by);

  // --- Export for the workshop: the files of the shown panels, certified. Prepared in the background while
  // it is wanted, anew after every change; written in the background.
  std::optional<ExportChoice> wanted_export;  // the window says each frame what the open dialog wants
  // Why nothing can be exported now, and what to do.
  std::optional<Error> why_no_export() const;
  bool export_preparing() const;
  // Of the panels that are shown, perhaps with settings of shortly before; null until it is there.
  const PreparedExport* export_preparation() const;
  const std::optional<Error>& export_refusal() const { return export_work_.refusal(); }  // to prepare
  // Once it is prepared. False if nothing can be exported now, or an export is under way. Its names are kept
  // when it comes to an end; while nothing is wanted any more, that becomes a message.
  bool export_panels_to_workshop(const ExportChoice& choice, const std::filesystem::path& folder,
                                 bool overwrite);
  bool exporting_to_workshop() const { return export_work_.writing(); }
  void stop_export() { export_work_.stop(); }
  bool export_stopping() const { return export_work_.stopping(); }
  ExportStage export_stage() const { return export_work_.stage(); }
  // How the newest export ended; nothing while one is under way, before the first, or once forgotten.
  const std::optional<ExportOutcome>& export_outcome() const { return export_outcome_; }
  const std::optional<Error>& export_error() const { return export_error_; }
  const std::filesystem::path& export_target() const { return export_target_; }  // of the newest export
  bool export_stopped() const { return export_stopped_; }
  void forget_export_outcome();

  // --- Suggestions: edits of the mesh that would better the active layer's panels, each rated by solving
  // its neighbourhood. A worker begins once a solve has come to a result and nothing else is under way, and
  // ends with every change. What it has found out stays with the result for as long as a moment of the
  // history has that: undo and redo bring it back, as it takes seconds to find out and little to keep. What
  // was interrupted is rated anew.
  // The newest that is of the present mesh; while another solve runs, of the result before. Null: none.
  std::shared_ptr<const Advice> advice() const;
  // Whether it is of what is shown, and not of a result before.
  bool advice_fits() const { return advising_ != nullptr; }
  bool rating() const { return advising_ != nullptr && advice_ != nullptr && !advice_->done; }
  // Those of kinds that are not hidden, best first.
  const SuggestionList& suggestion_list() const;
  // The row of the list that the designer has gone to; stays with its edit while others come.
  std::optional<int> current_suggestion() const;
  // Makes it the current one, and asks the viewport to go there.
  void show_suggestion(int row);
  void walk_suggestions(int by);
  // What Enter applies: the current one, else the best one at the current finding. Null: there is none.
  const Suggestion* suggestion_at_hand() const;
  // Each a step of undo; solved again at once.
  bool apply_suggestion(const Suggestion& suggestion);
  bool apply_all_suggestions();  // that lie apart: SuggestionList::together
  // The number, which outlives edits, of what an edit names; and the edit with it, as steps are called:
  // "Flip edge 1042".
  int element_number(const MeshEdit& edit) const;
  std::string edit_name(const MeshEdit& edit) const;
  // What an edit of the present mesh would look like; null, and asked for, while that is not known. Only
  // while advice_fits().
  std::shared_ptr<const EditPreview> preview(const MeshEdit& edit);
  std::optional<MeshEdit> pointed_edit;  // by the mouse, in the list
  bool pointed_all = false;              // at what applies all together

  // --- Pins of the active layer.
  // Holds what is selected where it is shown: points by all three coordinates, panels in their planes.
  // Returns how many are new or moved.
  int pin_selection();
  int unpin_selection();
  void change_pin(int pin, Pin changed, std::string what, std::string merge_key = {});
  // To a place in scene coordinates; coordinates that are not held stay free. One step of undo until
  // end_merge().
  void move_pin(int pin, const Vector3d& place);
  void remove_pin(int pin);
  void remove_plane_pin(int pin);
  // Where a pin holds its point, scene coordinates; what is not held is where the point is shown. Nothing
  // where the shown panels do not have the point.
  std::optional<Vector3d> pin_place(const Pin& pin) const;
  std::optional<int> shown_point(const PointOrigin& origin) const;
  std::optional<int> shown_panel(int plane_origin) const;

  // --- Solving.
  enum class Start { Warm, Afresh };  // from the newest state, or from the builder's own
  void solve(Start start = Start::Warm);
  void stop();
  // A polish included.
  bool solving() const {
    return solve_wanted_ || outcome_due_ || next_waiting() >= 0 || next_to_polish() >= 0;
  }
  // Whether what the active layer was last solved from, or is being solved from, is the present design.
  bool up_to_date() const { return document_.empty() || !run(active_layer()).stale; }
  void set_auto_solve(bool on) { auto_solve_ = on; }
  bool auto_solve() const { return auto_solve_; }

  // --- Polishing: every solve is the tangent solver's; Ipopt can go on from its result, and confirm it.
  bool can_polish() const;  // the active layer has such a result, of the present design
  void polish();
  bool polishing() const;  // what the solver works on (solving_layer()) is a polish
  bool polished() const;   // what is shown of the active layer is what a polish came to
  // Each result that comes to a good end is polished, once no control is held.
  void set_polish_automatically(bool on) { polish_automatically_ = on; }
  bool polish_automatically() const { return polish_automatically_; }
  // With which the newest solve of the active layer was started.
  SolverKind asked_solver() const { return run(active_layer()).asked; }

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
  const std::shared_ptr<const PreparedView>& shown() const { return shown(active_layer()); }
  // Scalars of the newest solve of the active layer that has delivered some.
  const std::vector<Iteration>& history() const { return run(active_layer()).history; }
  // The newest of them that is of the layer's newest solve; null: it has not delivered any yet.
  const Iteration* newest_step() const;
  // How the active layer's newest finished solve ended; null before the first.
  const SolveReport* report() const { return report(active_layer()); }
  // What each energy adds to the objective: of the newest step while a solve runs, else of the report.
  const std::vector<SolveReport::Energy>& energies() const { return run(active_layer()).energies; }
  // All shown work belongs to the newest change, and nothing is under way.
  bool settled() const;
  // Mean of the newest solve that has made two; 0 if unknown.
  double milliseconds_per_step() const { return run(active_layer()).milliseconds_per_step; }
  // Different states of the running (or last) solve that were shown before it ended.
  int iterates_before_end() const { return iterates_before_end_; }
  std::uint64_t ticket() const { return session_.current_ticket(); }
  // The upper end of the colour map's range (0 without one): grows during a solve, starts anew with the next
  // design, and stands still when locked.
  double colour_range() const;
  double planarity_tolerance() const;  // model units: below it a panel counts as planar

  ViewOptions view_options;
  Tool tool = Tool::Look;
  SelectWhat select_what = SelectWhat::Panels;  // what boxes, loops and the border select
  // What was pointed at last, of the shown panels; at most one of them.
  std::optional<int> selected_panel;
  std::optional<int> selected_point;
  std::optional<int> selected_edge;  // a panel edge

  // --- Messages.
  const std::vector<Message>& messages() const { return messages_; }
  void post(Message::Kind kind, std::string what, std::string where = {}, std::string remedy = {});
  void post(const Error& error);
  void dismiss(std::uint64_t message);
  std::uint64_t messages_posted() const { return next_message_ - 1; }

  FrameTimings timings;

 private:
  struct Loaded {  // a mesh or a project
    std::optional<CheckedMesh> mesh;
    std::shared_ptr<ReadProject> project;
    std::filesystem::path path;                                                // of the project
    std::optional<Result<std::shared_ptr<const ReferenceSurface>>> reference;  // that the project names
    std::string name;
  };
  // Equal: nothing that a project file keeps has changed.
  struct DocumentState {
    std::uint64_t moment = 0, names_given = 0;
    bool operator==(const DocumentState&) const = default;
  };

  // Of every layer, as a moment of the document keeps them.
  struct ShownLayers;
  using LoadedReference = std::pair<std::string, Result<std::shared_ptr<const ReferenceSurface>>>;

  const LayerRun& run(int layer) const;
  LayerRun& active_run() { return runs_[static_cast<std::size_t>(active_layer())]; }
  LayerRun* find_run(std::uint64_t id);
  void match_runs();     // with the document's layers, after these have changed
  void refresh_stale();  // after anything that layers are solved from has changed
  LayerInputs inputs_of(int layer) const;
  int next_waiting() const;  // the layer to be solved next in the background, -1: none
  void show_settings_of_views();
  void submit(LayerRun& of);
  bool take_reference();
  void set_reference(std::string path, Result<std::shared_ptr<const ReferenceSurface>> read);
  bool reference_missing() const;  // the one that the design names could not be used: nothing is solved
  void hold_without_reference();
  bool reference_ready() const;

  void begin_load(std::string name, std::function<Result<Loaded>()> load);
  void adopt(Loaded loaded);
  void adopt_mesh(Loaded loaded);
  void begin_design();
  static Result<Loaded> load_project_file(const std::filesystem::path& path);
  void adopt_project(Loaded loaded);
  // A layer's panels, as they were saved; false if they cannot be of this design.
  bool show_saved(LayerRun& of, const Layer& layer, State state);
  DocumentState document_state() const;
  bool update_saving();
  void document_changed();
  void tell_of_dropped(const std::vector<std::string>& dropped);
  bool mesh_edited(const Result<std::vector<std::string>>& edited, std::uint64_t revision, bool drags);
  void follow_pointed_at(const PreparedView& before, const PreparedView& next);
  void follow_elements();  // what is selected names the present mesh's elements
  std::shared_ptr<const ShownResults> results_now() const;
  void remember_results();  // as what is shown of the present moment
  void restore_results();
  // From the mesh of the shown panels to the present one; nothing if the elements are the same.
  std::optional<ElementMap> since_shown() const;
  // The result of a layer, if it is of a mesh with these elements; else null.
  std::shared_ptr<const Iterate> finished(int layer, const std::shared_ptr<const ElementIds>& ids) const;
  void refresh_mesh_view();
  bool drain();
  void take_energies(LayerRun& of);
  static void take_pace(LayerRun& of);
  void take_outcome(LayerRun& of, SolveOutcome outcome);
  bool can_polish(const LayerRun& of) const;
  int next_to_polish() const;  // the layer to be polished next, -1: none
  static bool takes_over(const LayerRun& of, const SolveOutcome& polish);
  void decline_polish(LayerRun& of, const SolveOutcome& polish);
  bool show_prepared();
  bool findings_known(const LayerRun& of) const;
  void follow_finding();  // the current one, in the list of newer findings
  void go_to_row(int row);
  void show_view(LayerRun& of, std::shared_ptr<const PreparedView> next);
  // What is to become of the clusters. `make` gets those that are there when its turn comes; null: none.
  struct ClusterWish {
    std::function<Result<Painted>(const SharedClusters&, std::stop_token)> make;
    std::string what, merge_key;
    bool is_step = true;   // else part of the newest
    bool by_hand = false;  // every one counts; of others the newest
    bool paints = false;
  };
  bool clusters_wanted() const;
  void wish(ClusterWish wish);
  void start_clustering();
  void stop_clustering();
  bool update_clusters();
  void take_clusters(Result<Painted> made);
  void take_stroke(const Painted& painted);
  void drop_cluster_wishes();
  bool update_region_view();
  bool update_cluster_report();

  WorkshopKey workshop_key() const;  // of what is shown; precondition: something is
  WorkshopJob workshop_job() const;  // likewise
  bool workshop_known() const;       // nothing is to be found out
  bool update_workshop();
  bool update_sheet();
  void follow_failure();

  std::optional<ExportJob> export_job(const ExportChoice& choice) const;  // nothing: there is none now
  void prepare(const ExportJob& job);
  bool update_export();
  void take_export(ExportEnd end);

  bool update_advice();
  bool take_advice();
  bool may_advise() const;
  void begin_advice();
  void end_advice();
  bool view_range_locked() const;
  bool may_start(Clock::time_point now) const;
  static bool has_advanced(const LayerRun& of);
  void start_solve(int layer, Clock::time_point now, SolverKind solver = SolverKind::Tangent);

  std::function<void()> wake_;
  Document document_;
  BackgroundTask<Result<Loaded>> loader_;
  BackgroundTask<Result<std::string>> exporter_;
  BackgroundTask<Result<std::filesystem::path>> saver_;
  std::filesystem::path project_path_;
  std::uint64_t saving_design_ = 0;           // opened_count_ of what is being saved
  DocumentState loading_state_;               // as it was when the newest load began
  DocumentState saved_state_, saving_state_;  // as it was last saved or opened; as it is being saved
  std::string loading_name_;
  std::function<void()> load_next_;  // asked for while another was loading
  std::uint64_t opened_count_ = 0;

  Vector3d scene_origin_ = Vector3d::Zero();
  std::shared_ptr<const MeshView> mesh_view_;
  std::shared_ptr<const PreparedGhost> ghost_;

  std::vector<LayerRun> runs_{LayerRun{}};  // one per layer
  std::uint64_t next_run_ = 1;
  std::uint64_t next_job_ = 1;
  std::uint64_t solving_run_ = 0;   // whose ticket the session works on; 0: nobody's
  bool outcome_due_ = false;        // of that ticket
  bool background_wanted_ = false;  // layers that are stale are solved in turn
  std::shared_ptr<const ReferenceSurface> reference_;
  std::string reference_path_;             // that reference_ was read from, or could not be
  std::optional<Error> reference_error_;   // why not
  std::uint64_t reference_complaint_ = 0;  // message about it, 0: none
  BackgroundTask<LoadedReference> reference_loader_;

  Selection selection_;
  std::shared_ptr<const ElementIds> selection_ids_;  // of the mesh that it belongs to
  std::uint64_t selection_changes_ = 0;
  std::optional<LookAt> look_at_;

  mutable FindingList finding_list_;    // made anew by finding_list() where it is not of the present state
  std::optional<int> current_finding_;  // index into the findings
  int next_row_ = 0;                    // where walking goes on when the current one is gone
  std::optional<Finding> walked_;       // the current one, or the last that was
  FindingSettings finding_settings_;

  std::shared_ptr<Advice> advice_;           // the newest
  std::uint64_t advice_layer_ = 0;           // whose
  std::shared_ptr<const Iterate> advising_;  // what the task's job is about; null: it has none
  std::uint64_t next_advice_ = 1;
  std::vector<std::shared_ptr<Advice>> known_advice_;         // finished, of results that are still there
  std::vector<std::shared_ptr<const EditPreview>> previews_;  // of the task's job
  std::optional<MeshEdit> preview_wanted_;                    // the newest that the task was asked for
  mutable SuggestionList suggestion_list_;  // made anew by suggestion_list() where it is of another state
  std::optional<MeshEdit> current_suggestion_;

  BackgroundTask<Result<Painted>> cluster_task_;
  std::stop_source cluster_stop_;
  std::optional<ClusterWish> clustering_wish_;  // that the task works on; none: its result is nobody's
  Clock::time_point clustering_since_{};
  double clustering_ms_ = 0.0;
  std::deque<ClusterWish> cluster_wishes_;       // whose turn is to come
  std::optional<ClusterOptions> cluster_asked_;  // that the clusters do not meet yet, or cannot
  std::optional<Error> cluster_error_;
  bool clustering_cut_short_ = false;  // by the designer, who keeps what there is
  bool merge_ends_late_ = false;       // a control was let go of whose last value is being clustered
  struct Stroke {
    int from = 0;
    std::vector<int> waiting;  // faces
    std::optional<Error> refused;
    std::uint64_t number = 0;
    bool ended = false;
  };
  std::optional<Stroke> stroke_;
  std::uint64_t next_stroke_ = 1;
  BackgroundTask<std::shared_ptr<const RegionView>> region_task_;
  std::shared_ptr<const RegionView> region_view_;
  struct MeasuredClusters {
    std::shared_ptr<const Iterate> iterate;
    ClusterReport report;
  };
  BackgroundTask<std::shared_ptr<const MeasuredClusters>> measure_task_;
  std::shared_ptr<const MeasuredClusters> measured_;  // null: none yet
  mutable std::vector<int> selected_regions_;
  mutable std::pair<std::uint64_t, SharedClusters> selected_regions_of_;

  struct SheetFile {
    std::string name;
    std::optional<ToleranceSheet> loaded;  // none: it was written
  };
  BackgroundTask<Result<SheetFile>> sheet_task_;
  std::uint64_t sheet_design_ = 0;    // opened_count_ of the design whose sheet it is
  std::uint64_t names_given_ = 0;     // how often
  mutable FailureList failure_list_;  // made anew by failure_list() where it is of another state
  std::optional<ToleranceFailure> current_failure_;
  int next_failure_ = 0;

  std::shared_ptr<const WorkshopModel> export_model_;  // of the newest preparation
  std::shared_ptr<const Iterate> export_iterate_;      // whose panels these are
  std::uint64_t export_layer_ = 0;                     // of the newest export
  PanelSeries export_series_{};                        // likewise
  std::filesystem::path export_target_;                // likewise
  std::optional<ExportOutcome> export_outcome_;
  std::optional<Error> export_error_;
  bool export_stopped_ = false;

  int iterates_before_end_ = 0;
  std::uint64_t last_fingerprint_ = 0;
  double planarity_range_ = 0.0, displacement_range_ = 0.0;

  bool auto_solve_ = true;
  bool polish_automatically_ = false;
  bool solve_wanted_ = false;
  bool start_afresh_ = false;
  bool solve_is_step_ = false;  // the designer has asked for the solve that is under way
  bool merging_ = false;        // a slider is being dragged
  Clock::time_point last_start_{};
  std::vector<Iteration> drained_;

  std::vector<Message> messages_;
  std::uint64_t next_message_ = 1;

  // Last members: their threads end before what they refer to goes.
  ViewPreparer preparer_;
  SolveSession session_;
  AdviceTask advice_task_;
  ExportWork export_work_;
  WorkshopWatch workshop_watch_;
};

}  // namespace planewright::ui
