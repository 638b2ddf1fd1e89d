// Finding: one bad place of solved panels, with what was measured there, against which threshold, and why it
// is bad in a designer's words ([Z 4.3] "the importance of good input meshes", the inset of [Z 3], and the
// turning points of [Z 4.1]).
//
// Units: a place is in model units, absolute; measures and thresholds are in the unit that they name, "edges"
// being mean panel edges (TangentComplex::mean_edge), so that thresholds fit designs of any size. Indices: of
// the TangentComplex and of its mesh, 0-based. Threads: plain values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/problem/element.h"

namespace planewright {

enum class FindingKind {
  IllDetermined,   // a point whose planes are nearly parallel
  ClosePoints,     // a panel edge next to no length
  ReversedEdge,    // a panel edge that runs backwards
  SelfCrossing,    // a panel whose outline crosses itself
  FoldedOver,      // a panel that lies over one it shares a corner with, or is turned over
  CrossingPanels,  // two panels without a common corner that penetrate each other
  NotConvex,       // a panel with a reflex corner where a convex one is possible
  FarPoint,        // a point far from where it was wanted
  CollapsedQuad,   // a quad that has become a triangle: a turning point of its strip
  TwistedBeam,     // a beam between two layers whose two edges are not parallel
};
inline constexpr int kFindingKinds = 10;
const std::array<FindingKind, kFindingKinds>& all_finding_kinds();

struct FindingKindInfo {
  const char* name;   // "reversed-edge": in reports and options
  const char* title;  // "reversed edge": for people
  const char* unit;   // of measure and threshold: "edges", "edges per degree", "degrees", ""
  // The threshold that FindingSettings begin with. IllDetermined: 0, which stands for the design's own
  // (notable_tilt_move()).
  double threshold;
  // Severity at the threshold, and at the worst that there is. One scale for all kinds: below 0.3 a blemish,
  // from 0.3 hard to build, from 0.7 not to be built as it is, 1 hopeless.
  double least_severity, most_severity;
};
const FindingKindInfo& info(FindingKind kind);
// Whether an edit of the mesh is the remedy: a reflex corner or a twisted beam is none of the mesh's faults.
bool calls_for_edits(FindingKind kind);
// Fails with ErrorCode::Usage, the known names listed.
Result<FindingKind> find_finding_kind(const std::string& name);

struct Finding {
  FindingKind kind = FindingKind::IllDetermined;
  ElementRef element;
  std::optional<ElementRef> second;   // where two take part
  Vector3d place = Vector3d::Zero();  // model units, absolute
  double measure = 0.0, threshold = 0.0;
  std::string unit;             // of both
  double severity = 0.0;        // 0..1, comparable between kinds
  std::string cause;            // one clause, for the designer
  std::vector<int> mesh_edges;  // edges of the mesh (InputSurface::edges) that an edit here would change
};

struct FindingSettings {
  struct Of {
    bool on = true;
    double threshold = 0.0;
    bool operator==(const Of&) const = default;
  };
  FindingSettings();  // all on, at the thresholds of info()
  Of& operator[](FindingKind kind) { return kinds[static_cast<size_t>(kind)]; }
  const Of& operator[](FindingKind kind) const { return kinds[static_cast<size_t>(kind)]; }
  bool operator==(const FindingSettings&) const = default;

  std::array<Of, kFindingKinds> kinds;
  // NotConvex: angle defect of a mesh vertex, degrees, above which a convex panel is possible there:
  // above rounding, so that flat and cylindrical places are left alone.
  double least_defect = 1e-3;
  // How far a point may lie from its planes, mean edges, for a state to count as solved.
  double planar = 1e-6;
};

// A finding with everything that its kind decides; share: 0 at the threshold .. 1 as bad as it gets.
Finding make_finding(FindingKind kind, ElementRef element, double measure, double threshold, double share);

}  // namespace planewright
