// Meshes to cluster, and checks of what came out.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/cluster/clustering.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "support/shapes.h"

namespace planewright::test {

inline FaceGraph graph_of(const PolygonMesh& mesh) {
  return FaceGraph::create(mesh).value();
}

// A sphere: an octahedron whose triangles are cut into n x n each.
inline Shape sphere(int n) {
  Shape shape;
  const Shape base = octahedron();
  std::vector<Vector3d> points;
  const auto index = [&](const Vector3d& p) {
    for (size_t k = 0; k < points.size(); ++k)
      if ((points[k] - p).norm() < 1e-9) return static_cast<int>(k);
    points.push_back(p);
    return static_cast<int>(points.size()) - 1;
  };
  for (int f = 0; f < base.faces.size(); ++f) {
    const auto t = base.faces[f];
    const Vector3d a = base.positions.row(t[0]), b = base.positions.row(t[1]), c = base.positions.row(t[2]);
    const auto at = [&](int i, int j) { return index((a + (b - a) * i / n + (c - a) * j / n).normalized()); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        shape.faces.push_back(std::array{at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < n) shape.faces.push_back(std::array{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  shape.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (size_t k = 0; k < points.size(); ++k) shape.positions.row(static_cast<Eigen::Index>(k)) = points[k];
  return shape;
}

// Two shapes beside each other.
inline Shape both(const Shape& a, Shape b, const Vector3d& moved) {
  const int shift = static_cast<int>(a.positions.rows());
  Shape shape = a;
  shape.positions.conservativeResize(shift + b.positions.rows(), 3);
  shape.positions.bottomRows(b.positions.rows()) = b.positions.rowwise() + moved.transpose();
  for (int f = 0; f < b.faces.size(); ++f) {
    std::vector<int> face;
    for (const int v : b.faces[f]) face.push_back(v + shift);
    shape.faces.push_back(face);
  }
  return shape;
}

// Every face in one connected region, each region with faces and a unit normal, errors that add up.
inline void expect_whole(const FaceGraph& graph, const Clustering& clustering, const ClusterMetric& metric) {
  const auto again = clustering_of(graph, clustering.region_of_face, metric);
  ASSERT_TRUE(again) << again.error().text();
  ASSERT_EQ(again->regions(), clustering.regions());
  EXPECT_NEAR(again->error, clustering.error, 1e-12);
  double sum = 0.0;
  for (int r = 0; r < clustering.regions(); ++r) {
    EXPECT_NEAR(clustering.proxies[r].normal.norm(), 1.0, 1e-12);
    EXPECT_GE(clustering.errors[r], 0.0);
    sum += clustering.errors[r];
  }
  EXPECT_NEAR(sum, clustering.error, 1e-12);
  // The error again, face by face.
  const ClusterMetric scaled = for_regions(metric, clustering.regions());
  double faces = 0.0;
  for (int f = 0; f < graph.face_count(); ++f)
    faces += graph.shapes[f].area *
             error_density(graph, f, clustering.proxies[clustering.region_of_face[f]], scaled);
  EXPECT_NEAR(faces, clustering.error, 1e-10);
}

}  // namespace planewright::test
