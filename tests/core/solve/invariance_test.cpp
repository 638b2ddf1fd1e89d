// The answer does not depend on where a model stands, how it is turned or which unit it is drawn in: moved,
// turned or scaled input gives the same points, moved, turned or scaled.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <sstream>

#include "core/mesh/mesh_io.h"
#include "support/shared_meshes.h"
#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

// y = scale * turn * x + shift
struct Transform {
  std::string name;
  double scale = 1.0;
  Matrix3d turn = Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();

  Points apply(const Points& points) const {
    return (scale * points * turn.transpose()).rowwise() + shift.transpose();
  }
  Points undo(const Points& points) const { return (points.rowwise() - shift.transpose()) * turn / scale; }
};

std::vector<Transform> transforms(double diagonal) {
  const Vector3d direction = Vector3d(0.6, -0.5, 0.3).normalized();
  std::vector<Transform> all(5);
  all[0].name = "shifted";
  all[0].shift = 1e6 * diagonal * direction;
  all[1].name = "turned";
  all[1].turn = Eigen::AngleAxisd(0.8, Vector3d(0.3, -1, 0.7).normalized()).toRotationMatrix();
  all[2].name = "turned on its side";
  all[2].turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  all[3].name = "a thousandth";
  all[3].scale = 1e-3;
  all[4].name = "a thousandfold";
  all[4].scale = 1e3;
  return all;
}

struct Solved {
  Points points;
  SolveReport report;
  double mean_edge;
};

Solved solved(const Points& positions, const Polygons& faces, ComplexKind kind) {
  const PolygonMesh mesh = PolygonMesh::from_polygons(positions, faces).value();
  const SharedComplex complex = kind == ComplexKind::Dual ? dual_of(mesh) : planarize_of(mesh);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const SolveReport report = solve(*problem);
  return {panels_of(*complex, report.state).points, report, complex->mean_edge};
}

void expect_invariant(const Points& positions, const Polygons& faces, ComplexKind kind) {
  const Solved reference = solved(positions, faces, kind);
  EXPECT_EQ(reference.report.status, SolveStatus::Converged) << reference.report.stop_reason;
  for (const Transform& transform : transforms(bounding_diagonal(positions))) {
    const Solved other = solved(transform.apply(positions), faces, kind);
    EXPECT_EQ(other.report.status, SolveStatus::Converged)
        << transform.name << ": " << other.report.stop_reason;
    const double difference = (transform.undo(other.points) - reference.points).rowwise().norm().maxCoeff();
    std::ostringstream measured;
    measured << difference / reference.mean_edge << " mean edges";
    testing::Test::RecordProperty(transform.name, measured.str());
    EXPECT_LE(difference / reference.mean_edge, 1e-6) << transform.name << ", " << reference.report.iterations
                                                      << " and " << other.report.iterations << " iterations";
    EXPECT_NEAR(other.mean_edge, transform.scale * reference.mean_edge,
                1e-6 * transform.scale * reference.mean_edge);
  }
}

TEST(Invariance, OfTheDomesDual) {
  const PolygonMesh mesh = make_sample("dome", 300).value();
  expect_invariant(mesh.positions(), mesh.faces(), ComplexKind::Dual);
}

TEST(Invariance, OfTheVaultsDual) {
  const PolygonMesh mesh = make_sample("vault", 300).value();
  expect_invariant(mesh.positions(), mesh.faces(), ComplexKind::Dual);
}

TEST(Invariance, OfARealRoofMadePlanar) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(meshes);
  const auto checked = load_mesh(meshes / "quad" / "inspired_mesh_quads_Conjugate.off");
  ASSERT_TRUE(checked) << checked.error().text();
  expect_invariant(checked->mesh.positions(), checked->mesh.faces(), ComplexKind::Planarize);
}

}  // namespace
}  // namespace planewright
