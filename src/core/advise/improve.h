// Improve: edits the mesh of a solved layer, a batch of suggestions at a time, and solves it again after
// each, until nothing that is suggested betters it.
//
// A round rates all candidates (advisor.h), applies the best that lie apart (edit_plan.h) from what their
// local solves found, and solves the whole design. It is kept if the total score B (score.h) of the whole
// falls; if not, half of the batch is tried, and a single edit that does not help is not tried again. Once no
// suggestion is left, findings that cannot be built as they are (panels that cross or fold over, points too
// close) get every flip, join, split and collapse round them tried, at no cost for what those give up of the
// design. Every state on the way is planar; B never rises.
//
// Units: lengths and scores in mean panel edges of the design as it came. Indices: mesh elements are told by
// the number that they had in the mesh as it came; later ones follow on (ElementNumbering). Threads: as
// Solver; the observer is called on the calling thread. Deterministic.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/advise/advisor.h"
#include "core/advise/design_measure.h"
#include "core/design/layer_solve.h"

namespace planewright {

struct ImproveOptions {
  int max_edits = -1;  // -1: as many as help
  AdviceOptions advice = {};
  FindingSettings findings = {};
  SolveOptions solve = {};
};

struct ImproveReport {
  struct Applied {
    std::string what;  // "Flip edge 1042"
    double predicted = 0.0;
    int round = 0;  // from 1
  };
  struct Round {
    int rated = 0;                         // candidates
    int edits = 0;                         // of the batch that was kept; 0: none helped
    double predicted = 0.0, gained = 0.0;  // by B of the whole
  };
  struct Tried {
    std::string what;
    std::optional<double> gain;  // none: refused, or not to be solved
    std::string refused;         // the reason
  };
  // An unbuildable finding that is left, with all that was tried there.
  struct Left {
    Finding finding;
    double angle_defect = 0.0;  // degrees, the least of the mesh's inner vertices there: below 0 a saddle
    std::vector<Tried> tried;
  };
  DesignMeasure before, after;
  std::vector<Applied> applied;
  std::vector<Round> rounds;
  std::vector<Left> left;
  bool stopped = false;
  Advised design;                    // mesh, complex, state, settings after all edits
  ElementMap map;                    // from the mesh as it came
  SolveReport solve;                 // the last one that was kept; of no edit: empty
  std::vector<std::string> dropped;  // what settings named and is gone, each a line for the designer
};

class ImproveObserver {
 public:
  virtual ~ImproveObserver() = default;
  virtual void on_rated(int round, int rated, int of) = 0;
  virtual void on_round(int round, const ImproveReport::Round& result, const DesignMeasure& now) = 0;
};

// solved: planar, in the unit that its complex names. observer may be null. Fails as PatchSolver::create
// does; a stop ends with what was reached.
Result<ImproveReport> improve(Solver& solver, const Advised& solved, const ImproveOptions& options,
                              ImproveObserver* observer = nullptr, std::stop_token stop = {});

}  // namespace planewright
