// A thousand random edits with random undo and redo: the mesh stays valid, and undoing all of them brings it
// back bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "core/edit/document.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

int euler(const PolygonMesh& mesh) {
  return mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
}

class RandomEdits {
 public:
  RandomEdits(const PolygonMesh& mesh, unsigned seed) : random_(seed) {
    CheckedMesh checked;
    checked.mesh = mesh;
    document_.open(std::move(checked), "random", {});
    Design design = document_.design();
    Selection all{"all", {}, {}, {}};
    for (int v = 0; v < mesh.vertex_count(); ++v) all.vertices.push_back(v);
    for (int e = 0; e < mesh.edge_count(); ++e) all.edges.push_back(e);
    for (int f = 0; f < mesh.face_count(); ++f) all.faces.push_back(f);
    design.selections = {all};
    document_.change_design(design, "Select all");
    moments_.push_back(now());
  }

  void run(int edits) {
    const std::size_t opened = static_cast<std::size_t>(document_.steps_done());
    for (int made = 0; made < edits;) {
      const int choice = number(10);
      if (choice == 0 && moments_.size() > 1 && at_ > 0) {
        document_.undo();
        --at_;
      } else if (choice == 1 && document_.can_redo()) {
        document_.redo();
        ++at_;
      } else if (choice == 2 && number(20) == 0) {
        at_ = static_cast<std::size_t>(number(static_cast<int>(moments_.size())));
        document_.go_to(static_cast<int>(opened + at_));
      } else if (edit()) {
        ++made;
      } else {
        continue;
      }
      expect_valid();
      if (testing::Test::HasFailure()) return;
    }
    // Every moment is what it was, however it is reached.
    while (at_ > 0) {
      document_.undo();
      expect_same(moments_[--at_]);
    }
    while (document_.can_redo()) {
      document_.redo();
      expect_same(moments_[++at_]);
    }
    document_.go_to(static_cast<int>(opened));
    expect_same(moments_.front());
  }

  const std::map<EditKind, int>& made() const { return made_; }

 private:
  struct Snapshot {
    Points positions;
    Polygons faces;
    std::vector<std::array<int, 2>> edges;
    ElementIds ids;
    Design design;
  };

  Snapshot now() const {
    const PolygonMesh& mesh = *document_.mesh();
    Snapshot snapshot{mesh.positions(), mesh.faces(), {}, *document_.ids(), document_.design()};
    for (int e = 0; e < mesh.edge_count(); ++e) snapshot.edges.push_back({mesh.edge(e).a, mesh.edge(e).b});
    return snapshot;
  }

  void expect_same(const Snapshot& then) const {
    const Snapshot present = now();
    EXPECT_TRUE(same_bits(present.positions, then.positions));
    EXPECT_EQ(present.faces, then.faces);
    EXPECT_EQ(present.edges, then.edges);
    EXPECT_EQ(present.ids, then.ids);
    EXPECT_EQ(present.design, then.design);
  }

  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }

  MeshEdit candidate() {
    const PolygonMesh& mesh = *document_.mesh();
    // Splits and collapses in turn, so that the mesh keeps about its size.
    constexpr std::array kKinds{EditKind::Flip,      EditKind::Join,     EditKind::SplitEdge,
                                EditKind::SplitFace, EditKind::Collapse, EditKind::MoveVertex,
                                EditKind::DeleteFace};
    MeshEdit edit{kKinds[static_cast<std::size_t>(number(static_cast<int>(kKinds.size())))]};
    if (mesh.face_count() < 40 && (edit.kind == EditKind::DeleteFace || edit.kind == EditKind::Join)) {
      edit.kind = EditKind::SplitEdge;
    }
    switch (edit.kind) {
      case EditKind::MoveVertex:
        edit.element = number(mesh.vertex_count());
        edit.to = Vector3d(number(100), number(100), number(100)) / 7.0;
        break;
      case EditKind::SplitFace: {
        edit.element = number(mesh.face_count());
        const std::vector<int> corners = mesh.corners(edit.element);
        for (int& corner : edit.corners)
          corner = corners[static_cast<std::size_t>(number(static_cast<int>(corners.size())))];
        break;
      }
      case EditKind::DeleteFace:
        edit.element = number(mesh.face_count());
        break;
      default:
        edit.element = number(mesh.edge_count());
    }
    return edit;
  }

  // What the Euler characteristic becomes: only a deleted face changes it, by what goes with it.
  int expected_euler(const MeshEdit& edit) const {
    const PolygonMesh& mesh = *document_.mesh();
    int expected = euler(mesh);
    if (edit.kind != EditKind::DeleteFace) return expected;
    const std::vector<int> corners = mesh.corners(edit.element);
    --expected;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (mesh.faces_around(corners[k]).size() == 1) --expected;
      if (mesh.edge(mesh.find_edge(corners[k], corners[(k + 1) % corners.size()])).border()) ++expected;
    }
    return expected;
  }

  bool edit() {
    const MeshEdit edit = candidate();
    if (!document_.may_edit(edit)) return false;
    const PolygonMesh before = *document_.mesh();
    const ElementIds ids = *document_.ids();
    const int expected = expected_euler(edit);
    const auto done = document_.edit_mesh(edit);
    EXPECT_TRUE(done) << describe(edit) << ": " << done.error().text() << " though it may be applied";
    if (!done) return true;
    EXPECT_EQ(euler(*document_.mesh()), expected) << describe(edit);
    // Survivors are where they were.
    const IndexMap vertices = map_between(ids, *document_.ids()).vertices;
    int moved = 0;
    for (std::size_t v = 0; v < vertices.to_old.size(); ++v) {
      if (vertices.to_old[v] < 0) continue;
      moved += before.positions().row(vertices.to_old[v]) !=
               document_.mesh()->positions().row(static_cast<Eigen::Index>(v));
    }
    EXPECT_LE(moved, edit.kind == EditKind::MoveVertex || edit.kind == EditKind::Collapse ? 1 : 0);
    moments_.resize(++at_);
    moments_.push_back(now());
    ++made_[edit.kind];
    return true;
  }

  void expect_valid() const {
    const PolygonMesh& mesh = *document_.mesh();
    const auto again = PolygonMesh::from_polygons(mesh.positions(), mesh.faces());
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->edge_count(), mesh.edge_count());
    EXPECT_EQ(static_cast<int>(document_.ids()->vertices.size()), mesh.vertex_count());
    EXPECT_EQ(static_cast<int>(document_.ids()->edges.size()), mesh.edge_count());
    EXPECT_EQ(static_cast<int>(document_.ids()->faces.size()), mesh.face_count());
    for (const auto* ids : {&document_.ids()->vertices, &document_.ids()->edges, &document_.ids()->faces}) {
      std::vector<int> sorted = *ids;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end()) << "a number is given twice";
    }
    for (const Selection& selection : document_.design().selections) {
      for (const int v : selection.vertices) EXPECT_LT(v, mesh.vertex_count());
      for (const int e : selection.edges) EXPECT_LT(e, mesh.edge_count());
      for (const int f : selection.faces) EXPECT_LT(f, mesh.face_count());
    }
  }

  std::mt19937 random_;
  Document document_;
  std::vector<Snapshot> moments_;
  std::size_t at_ = 0;
  std::map<EditKind, int> made_;
};

TEST(RandomEdits, LeaveTrianglesValidAndAreUndoneBitForBit) {
  RandomEdits edits(make_torus(10, 10), 1);
  edits.run(1000);
  EXPECT_EQ(edits.made().size(), 7u) << "every kind had its turn";
}

TEST(RandomEdits, LeaveQuadsValidAndAreUndoneBitForBit) {
  RandomEdits edits(twisted_grid(10, 8).mesh(), 2);
  edits.run(1000);
  EXPECT_EQ(edits.made().size(), 7u);
}

TEST(RandomEdits, LeaveSmallMeshesValid) {
  unsigned seed = 3;
  for (const Shape& shape : {cube(), octahedron(), honeycomb(4, 3), fan(6, true)}) {
    RandomEdits edits(shape.mesh(), seed++);
    edits.run(150);
  }
}

}  // namespace
}  // namespace planewright
