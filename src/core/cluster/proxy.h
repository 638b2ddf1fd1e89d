// Proxies: the plane that stands for a region, the metrics that say how badly, and the best proxy of a
// region.
//
// Of face T with unit normal n_T and region proxy (centre c, unit normal n), the error is the integral over
// T, everything in the frame of the FaceGraph (area 1, lengths in square roots of the area), so that no term
// knows the model's scale or the fineness of its mesh:
//
//   normal       |n_T - n|^2                 L2,1 of Cohen-Steiner, Alliez and Desbrun, "Variational Shape
//                                            Approximation", 2004
//   distance     K ((x - c) . n)^2           L2 there; K, the number of regions, makes the mean region's size
//                                            the unit of length, so that the term shrinks with K as the
//                                            normal term does
//   compactness  |x_T - c|^2                 x_T: the face's centre; keeps regions round where the surface is
//                                            flat
//
// blended by weights, as Cutler and Whiting do in "Constrained Planar Remeshing for Architecture", 2007
// (there with weights set per model; the units above are ours). Threads: plain values and pure functions.
#pragma once

#include "core/cluster/face_graph.h"

namespace planewright {

struct ClusterMetric {
  // Of regions by normals alone more panels cross themselves, and they are farther from the mesh.
  double normal = 1.0;
  double distance = 50.0;
  double compactness = 0.5;

  static ClusterMetric l21() { return {1.0, 0.0, 0.0}; }
  static ClusterMetric l2() { return {0.0, 1.0, 0.0}; }
  bool operator==(const ClusterMetric&) const = default;
};
// Refused (ErrorCode::Usage): a weight that is negative or not finite, normal and distance both 0.
Result<void> check_metric(const ClusterMetric& metric);
// `metric` with the distance's K of the table above in its weight.
ClusterMetric for_regions(ClusterMetric metric, int regions);

// In the frame of the FaceGraph.
struct Proxy {
  Vector3d centre = Vector3d::Zero();
  Vector3d normal = Vector3d::UnitZ();  // unit
};

// The error per area of face f, its own extent included. metric: of for_regions().
inline double error_density(const FaceGraph& graph, int f, const Proxy& proxy, const ClusterMetric& metric) {
  const FaceShape& shape = graph.shapes[f];
  const Vector3d arm = shape.centre - proxy.centre;
  double density = metric.compactness * arm.squaredNorm();
  if (shape.area <= 0.0) return density;
  density += metric.normal * (shape.normal - proxy.normal).squaredNorm();
  if (metric.distance > 0.0) {
    const SecondMoments& m = graph.moments[f];
    const Vector3d& n = proxy.normal;
    const double height = arm.dot(n);
    const double extent = m[0] * n.x() * n.x() + m[3] * n.y() * n.y() + m[5] * n.z() * n.z() +
                          2.0 * (m[1] * n.x() * n.y() + m[2] * n.x() * n.z() + m[4] * n.y() * n.z());
    density += metric.distance * (height * height + extent / shape.area);
  }
  return density;
}

// Sums over the faces of a region, from which proxy and error follow without looking at the faces again;
// those of two regions add up to those of their union.
struct RegionSums {
  double area = 0.0;
  Vector3d normal = Vector3d::Zero();             // area * normal
  Vector3d centre = Vector3d::Zero();             // area * centre
  double centre_squared = 0.0;                    // area * |centre|^2
  SecondMoments moments = SecondMoments::Zero();  // about the frame's origin
  int faces = 0;

  void add(const FaceGraph& graph, int f);
  RegionSums& operator+=(const RegionSums& other);
};

struct FittedProxy {
  Proxy proxy;
  double error = 0.0;     // by the metric
  double normal = 0.0;    // the integral of |n_T - n|^2
  double distance = 0.0;  // of ((x - c) . n)^2, without the K
};
// The proxy with the least error, exactly for every blend. A region without area gets the normal z, one whose
// normals cancel out any normal. metric: of for_regions().
FittedProxy fit_proxy(const RegionSums& sums, const ClusterMetric& metric);

}  // namespace planewright
