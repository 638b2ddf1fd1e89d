// HealthReport: what is wrong with polygons that came from outside, where, and what the tool did about it.
//
// Indices are 0-based and refer to the file's own numbering (its n-th vertex or face), so that the designer
// finds them again. Elements are listed up to `kMaxListed`; `count` is always the whole number. Of one kind
// there is one Defect; its action tells apart what was done to some and to others.
#pragma once

#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

enum class DefectKind {
  NonManifoldEdge,          // more than two faces
  NonManifoldVertex,        // its faces form more than one fan
  InconsistentOrientation,  // faces that run through common edges in the direction of the neighbour; the
                            // turned ones are listed
  OneSided,         // no consistent orientation exists (a Moebius strip): counts such components, lists
                    // the edges of the seam
  RepeatedCorner,   // a face names a vertex twice (and has 3 distinct ones)
  DegenerateFace,   // fewer than 3 distinct corners, or (almost) no area
  DuplicateFace,    // the same corners as an earlier face
  DuplicateVertex,  // exactly the coordinates of an earlier vertex
  IsolatedVertex,   // no face of the repaired mesh uses it
  IndexBase,        // an OFF or PLY file that counts from 1; lists nothing
};
const char* name(DefectKind kind);  // "non-manifold edge", as a report prints it

struct Defect {
  static constexpr int kMaxListed = 100;
  DefectKind kind;
  int count = 0;
  std::vector<int> elements;  // vertices or faces; for edges, pairs (a, b) one after the other
  std::string action;         // what was done: "split into 2 vertices", "kept", "dropped", "turned round"
};

struct HealthReport {
  int vertices = 0, faces = 0;  // as the file has them
  int components = 0;           // faces joined through shared vertices, after the repair
  int border_loops = 0, border_edges = 0;
  std::vector<Defect> defects;  // empty: healthy
  bool repaired = false;        // the mesh differs from the file

  bool healthy() const { return defects.empty(); }
  const Defect* find(DefectKind kind) const;
  std::string summary()
      const;  // one line, "healthy" or "2 non-manifold edges (split), 1 isolated vertex (kept)"
};

struct CheckedMesh {
  PolygonMesh mesh;
  HealthReport health;
  std::vector<int> vertex_origin;  // #V: the file's vertex that each mesh vertex came from (splits repeat it)
  std::vector<int> face_origin;    // #F: the file's face
};

// Examines raw polygons and repairs what has one clear repair:
//   inconsistent orientation -> faces turned round (the majority of each component decides);
//   one-sided -> cut open along a seam (where the file's own orientation breaks, if it can be there);
//   non-manifold edge -> its faces detached (those that still meet round one end stay joined);
//   non-manifold vertex -> one copy per fan; repeated corner -> dropped from the face, the first one stays;
//   face with < 3 distinct corners, or a duplicate -> dropped;
//   faces of no area (< 1e-12 squared mean edges), duplicate and isolated vertices -> kept, and named.
// The mesh keeps the file's vertices in their order; copies of split ones follow at the end.
// Refuses (ErrorCode::Refused): no faces left, an index out of range, a coordinate that is not finite.
// Deterministic; n log n in the number of corners.
Result<CheckedMesh> check_and_repair(const Points& positions, const Polygons& faces);

}  // namespace planewright
