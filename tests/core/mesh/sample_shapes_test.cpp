#include "core/mesh/sample_shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/mesh/health_report.h"

namespace planewright {
namespace {

int panels_of(const SampleInfo& info, const PolygonMesh& mesh) {
  return info.triangles ? mesh.vertex_count() : mesh.face_count();
}

int euler_characteristic(const PolygonMesh& mesh) {
  return mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
}

TEST(SampleShapes, ListsAllOfThem) {
  std::set<std::string> names;
  for (const SampleInfo& info : samples()) {
    names.insert(std::string(info.name));
    EXPECT_FALSE(info.description.empty());
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"torus", "dome", "vault", "saddle-roof", "wave-roof", "alpine-hut",
                                   "train-station", "train-station-unsymmetric", "twisted-roof", "saddle",
                                   "straight-strip", "flat-patch-dome", "bad-saddle", "turning-strip"}));
}

TEST(SampleShapes, HaveAboutTheWishedNumberOfPanels) {
  for (const SampleInfo& info : samples()) {
    std::vector<int> wishes{1000, 2345, 10'000, 30'000};
    for (int n = 50; n < 400; n += 3) wishes.push_back(n);
    for (int wish : wishes) {
      const int got = panels_of(info, make_sample(info.name, wish).value());
      EXPECT_LT(std::abs(got - wish), 0.25 * wish) << info.name << " " << wish << " -> " << got;
    }
    const int by_default = panels_of(info, make_sample(info.name).value());
    EXPECT_LT(std::abs(by_default - info.default_panels), 0.05 * info.default_panels) << info.name;
    for (int wish = 8; wish < 50; ++wish) {
      const int got = panels_of(info, make_sample(info.name, wish).value());
      EXPECT_LE(got, 2 * wish) << info.name << " " << wish;
      EXPECT_GE(2 * got, wish) << info.name << " " << wish;
    }
  }
}

TEST(SampleShapes, AreHealthyAndOfTheRightKind) {
  for (const SampleInfo& info : samples())
    for (int panels : {8, 60, 500}) {
      const PolygonMesh mesh = make_sample(info.name, panels).value();
      const Polygons faces = mesh.faces();
      const auto checked = check_and_repair(mesh.positions(), faces);
      ASSERT_TRUE(checked) << info.name;
      EXPECT_TRUE(checked->health.healthy()) << info.name << ": " << checked->health.summary();
      EXPECT_EQ(checked->health.components, 1);
      const bool torus = info.name == "torus";
      EXPECT_EQ(euler_characteristic(mesh), torus ? 0 : 1) << info.name;
      EXPECT_EQ(checked->health.border_loops, torus ? 0 : 1) << info.name;
      for (int f = 0; f < faces.size(); ++f) ASSERT_EQ(faces.valence(f), info.triangles ? 3 : 4);
    }
}

TEST(SampleShapes, StandOnTheGroundAndLookUp) {
  for (const SampleInfo& info : samples()) {
    const PolygonMesh mesh = make_sample(info.name).value();
    EXPECT_EQ(mesh.positions().col(2).minCoeff(), 0.0) << info.name;
    const Polygons faces = mesh.faces();
    for (int f = 0; f < faces.size(); ++f) {
      const Vector3d normal = newell_vector(mesh.positions(), faces[f]);
      if (info.name != "torus") {
        ASSERT_GT(normal.z(), 0.0) << info.name << " face " << f;
        continue;
      }
      // Away from the circle in the middle of the tube.
      const Vector3d c = centroid(mesh.positions(), faces[f]);
      const Vector3d middle = Vector3d(c.x(), c.y(), 0.0).normalized() + Vector3d(0, 0, 0.4);
      ASSERT_GT(normal.dot(c - middle), 0.0);
    }
  }
}

TEST(SampleShapes, TrianglesAreWellShaped) {
  for (const SampleInfo& info : samples()) {
    const PolygonMesh mesh = make_sample(info.name).value();
    const Polygons faces = mesh.faces();
    for (int f = 0; f < faces.size(); ++f)
      for (int k = 0; k < faces.valence(f); ++k) {
        const auto n = static_cast<size_t>(faces.valence(f));
        const Vector3d at = mesh.positions().row(faces[f][k]);
        const Vector3d a = mesh.positions().row(faces[f][(k + 1) % n]).transpose() - at;
        const Vector3d b = mesh.positions().row(faces[f][(k + n - 1) % n]).transpose() - at;
        EXPECT_GT(a.normalized().cross(b.normalized()).norm(), 0.25) << info.name << " face " << f;
      }
  }
}

TEST(SampleShapes, AreHexagonDominantInTheDual) {
  for (const SampleInfo& info : samples()) {
    if (!info.triangles || info.name == "bad-saddle") continue;
    const PolygonMesh mesh = make_sample(info.name).value();
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (!mesh.is_border_vertex(v)) {
        EXPECT_EQ(mesh.faces_around(v).size(), 6u) << info.name;
      }
    }
  }
}

// The faces of the mesh mirrored in one coordinate are faces of the mesh.
bool symmetric(const PolygonMesh& mesh, int axis) {
  std::map<std::array<double, 3>, int> index;
  const Points& p = mesh.positions();
  for (int v = 0; v < p.rows(); ++v) index[{p(v, 0) + 0.0, p(v, 1) + 0.0, p(v, 2)}] = v;
  std::set<std::set<int>> faces;
  const Polygons list = mesh.faces();
  for (int f = 0; f < list.size(); ++f) faces.insert(std::set<int>(list[f].begin(), list[f].end()));
  for (int f = 0; f < list.size(); ++f) {
    std::set<int> mirrored;
    for (int v : list[f]) {
      std::array<double, 3> at{p(v, 0), p(v, 1), p(v, 2)};
      at[axis] = -at[axis];
      const auto found = index.find({at[0] + 0.0, at[1] + 0.0, at[2]});
      if (found == index.end()) return false;
      mirrored.insert(found->second);
    }
    if (!faces.count(mirrored)) return false;
  }
  return true;
}

TEST(SampleShapes, SymmetricOnesAreExactlyMirrored) {
  for (const char* name : {"vault", "saddle-roof", "wave-roof", "alpine-hut", "train-station", "saddle"})
    for (int panels : {0, 77, 1234}) {
      const PolygonMesh mesh = make_sample(name, panels).value();
      EXPECT_TRUE(symmetric(mesh, 0)) << name;
      EXPECT_TRUE(symmetric(mesh, 1)) << name;
    }
  const PolygonMesh mesh = make_sample("train-station-unsymmetric").value();
  EXPECT_FALSE(symmetric(mesh, 0));
  EXPECT_FALSE(symmetric(mesh, 1));
}

TEST(SampleShapes, TwistedRoofIsNotPlanar) {
  const PolygonMesh mesh = make_sample("twisted-roof").value();
  const Polygons faces = mesh.faces();
  for (int f = 0; f < faces.size(); ++f) {
    const Vector3d normal = newell_vector(mesh.positions(), faces[f]).normalized();
    const Vector3d side = (mesh.positions().row(faces[f][1]) - mesh.positions().row(faces[f][0])).transpose();
    EXPECT_GT(std::abs(normal.dot(side)) / side.norm(), 1e-3);
  }
}

TEST(SampleShapes, FlawedOnesHaveACleanVersionAndPlantedPlaces) {
  std::map<std::string_view, const SampleInfo*> by_name;
  for (const SampleInfo& info : samples()) by_name[info.name] = &info;
  int flawed = 0;
  for (const SampleInfo& info : samples())
    for (const int panels : {0, 200, 1000}) {
      const auto places = planted_places(info.name, panels).value();
      EXPECT_EQ(places.empty(), info.flaw_of.empty()) << info.name << " " << panels;
      if (info.flaw_of.empty()) continue;
      ++flawed;
      ASSERT_TRUE(by_name.contains(info.flaw_of)) << info.name;
      EXPECT_EQ(by_name[info.flaw_of]->triangles, info.triangles);
      const PolygonMesh mesh = make_sample(info.name, panels).value();
      EXPECT_EQ(panels_of(info, mesh), panels_of(info, make_sample(info.flaw_of, panels).value()));
      for (const PlantedPlace& place : places) {
        EXPECT_FALSE(place.what.empty());
        EXPECT_GT(place.edges.size() + place.faces.size(), 0u);
        for (const int edge : place.edges) EXPECT_TRUE(edge >= 0 && edge < mesh.edge_count());
        for (const int face : place.faces) EXPECT_TRUE(face >= 0 && face < mesh.face_count());
      }
    }
  EXPECT_EQ(flawed, 3 * 3);
  EXPECT_TRUE(planted_places("flat-patch-dome", 50).value().empty());
  EXPECT_EQ(planted_places("igloo").error().code, ErrorCode::Usage);
}

TEST(SampleShapes, PlantedPlacesAreWhereTheySay) {
  const PolygonMesh dome = make_sample("flat-patch-dome").value();
  const Polygons faces = dome.faces();
  const auto flat = planted_places("flat-patch-dome").value();
  for (const PlantedPlace& place : flat)
    for (const int v : faces[place.faces.at(0)])
      EXPECT_EQ(dome.positions()(v, 2), dome.positions().col(2).maxCoeff());
  // Flipped back, the saddle is the clean one.
  PolygonMesh saddle = make_sample("bad-saddle").value();
  const auto flipped = planted_places("bad-saddle").value();
  for (const PlantedPlace& place : flipped) EXPECT_TRUE(saddle.flip(place.edges.at(0)));
  for (int v = 0; v < saddle.vertex_count(); ++v) {
    if (!saddle.is_border_vertex(v)) {
      EXPECT_EQ(saddle.faces_around(v).size(), 6u);
    }
  }
}

TEST(SampleShapes, TorusHasTheExactGrid) {
  for (const auto& [rows, columns] : {std::pair{100, 100}, {7, 9}, {3, 3}, {4, 3}, {50, 200}}) {
    const PolygonMesh mesh = make_torus(rows, columns);
    EXPECT_EQ(mesh.vertex_count(), rows * columns);
    EXPECT_EQ(mesh.face_count(), 2 * rows * columns);
    EXPECT_EQ(euler_characteristic(mesh), 0);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const Vector3d p = mesh.positions().row(v);
      const double tube = std::hypot(std::hypot(p.x(), p.y()) - 1.0, p.z() - 0.4 * 1.0);
      if (rows % 4 == 0) {
        EXPECT_NEAR(tube, 0.4,
                    1e-12);  // with a row at the very bottom, the ring stands exactly on the ground
      }
    }
  }
}

TEST(SampleShapes, RefusesWhatItDoesNotKnow) {
  const auto unknown = make_sample("igloo");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
  EXPECT_NE(unknown.error().text().find("alpine-hut"), std::string::npos);
  for (int panels : {-1, 1, 7, 4'000'001}) {
    const auto wrong = make_sample("torus", panels);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, ErrorCode::Usage);
  }
}

TEST(SampleShapes, AreDeterministic) {
  for (const SampleInfo& info : samples()) {
    const PolygonMesh a = make_sample(info.name, 300).value(), b = make_sample(info.name, 300).value();
    EXPECT_EQ(a.positions(), b.positions());
    EXPECT_EQ(a.faces(), b.faces());
  }
}

}  // namespace
}  // namespace planewright
