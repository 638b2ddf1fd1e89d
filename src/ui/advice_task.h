// AdviceTask: rates edits of a solved layer's mesh on a thread of its own, and tells what single ones would
// lead to.
//
// Suggestions come one after another while the rest is still being rated. One job at a time: another one, or
// stop(), ends it within a step of a local solve, and nothing of it is heard any more. What the designer
// points at is looked at before the next edit is rated. The thread has a lower priority than the window's and
// the solver's, so that neither has to wait for the processor.
//
// Threads: all members from the window's; none of them waits for the worker's computing.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/design/solve_session.h"
#include "ui/edit_preview.h"
#include "ui/prepared_findings.h"

namespace planewright::ui {

inline const int kAdviceRadius = AdviceOptions().radius;  // rings of a patch, see patch_solver.h

struct AdviceJob {
  std::uint64_t number = 0;
  // What was solved, and what came of it.
  std::shared_ptr<const PolygonMesh> mesh;
  LayerSettings settings;
  std::vector<Selection> selections = {};
  std::shared_ptr<const ReferenceSurface> reference = {};
  std::shared_ptr<const Iterate> iterate;
  std::shared_ptr<const PreparedFindings> findings;  // of that iterate
  bool rates = true;                                 // false: only previews are wanted
};

// What has come since the last take.
struct AdviceNews {
  std::uint64_t number = 0;       // of the job
  std::vector<Suggestion> rated;  // those with enough gain, in the order of the candidates
  int tried = 0, candidates = 0;  // so far; of all
  bool listed = false;            // the candidates are known
  bool done = false;
  std::optional<Error> refused;  // why nothing can be rated; done
  std::vector<std::shared_ptr<const EditPreview>> previews;
};

class AdviceTask {
 public:
  // `wake`: called on the worker when there is something to take, a few times a second.
  explicit AdviceTask(std::function<void()> wake);
  ~AdviceTask();
  AdviceTask(const AdviceTask&) = delete;
  AdviceTask& operator=(const AdviceTask&) = delete;

  void submit(AdviceJob job);
  void stop();
  // A preview of an edit of the job's mesh; takes the place of a wish that was not begun yet.
  void want(const MeshEdit& edit, std::optional<Candidate> candidate);
  std::optional<AdviceNews> take();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright::ui
