#include "core/cluster/proxy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/cluster/partition.h"
#include "support/clusters.h"

namespace planewright {
namespace {

using namespace test;

const ClusterMetric kMetrics[] = {
    ClusterMetric::l21(), ClusterMetric::l2(), {1.0, 1.0, 0.0}, {0.3, 20.0, 0.1}, {1.0, 0.0, 1.0}};

RegionSums sums_of(const FaceGraph& graph, int step) {
  RegionSums sums;
  for (int f = 0; f < graph.face_count(); f += step) sums.add(graph, f);
  return sums;
}
double error_of(const FaceGraph& graph, int step, const Proxy& proxy, const ClusterMetric& metric) {
  double sum = 0.0;
  for (int f = 0; f < graph.face_count(); f += step)
    sum += graph.shapes[f].area * error_density(graph, f, proxy, metric);
  return sum;
}

TEST(Proxy, NoOtherProxyIsBetter) {
  std::mt19937 random(3);
  const auto next = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  for (const auto& mesh :
       {make_sample("saddle", 100).value(), make_sample("dome", 80).value(), make_torus(8, 8)}) {
    const FaceGraph graph = graph_of(mesh);
    for (const ClusterMetric& metric : kMetrics)
      for (const int step : {1, 3, 7}) {
        const FittedProxy best = fit_proxy(sums_of(graph, step), metric);
        EXPECT_NEAR(best.proxy.normal.norm(), 1.0, 1e-12);
        EXPECT_NEAR(best.error, error_of(graph, step, best.proxy, metric), 1e-12);
        for (int k = 0; k < 50; ++k) {
          const double size = std::pow(10.0, -k % 5);
          Proxy other = best.proxy;
          other.normal = (other.normal + size * Vector3d(next(), next(), next())).normalized();
          if (k % 2) other.centre += size * Vector3d(next(), next(), next());
          EXPECT_GE(error_of(graph, step, other, metric), best.error - 1e-13);
        }
      }
  }
}

TEST(Proxy, FindsTheNormalWhereTheSumsSayNothingOfOneAxis) {
  // A closed strip of a cylinder: normals cancel out, the axis is free for L2.
  const FaceGraph graph = graph_of(make_torus(6, 6));
  for (const ClusterMetric& metric : kMetrics) {
    const FittedProxy fitted = fit_proxy(sums_of(graph, 1), metric);
    EXPECT_NEAR(fitted.proxy.normal.norm(), 1.0, 1e-12);
    EXPECT_TRUE(std::isfinite(fitted.error));
  }
  const FittedProxy nothing = fit_proxy({}, ClusterMetric::l2());
  EXPECT_EQ(nothing.proxy.normal, Vector3d::UnitZ());
  EXPECT_EQ(nothing.error, 0.0);
}

TEST(Proxy, SumsOfTwoRegionsAreThoseOfTheirUnion) {
  const FaceGraph graph = graph_of(make_sample("saddle", 100).value());
  RegionSums a, b, all;
  for (int f = 0; f < graph.face_count(); ++f) {
    (f % 3 == 0 ? a : b).add(graph, f);
    all.add(graph, f);
  }
  a += b;
  for (const ClusterMetric& metric : kMetrics)
    EXPECT_NEAR(fit_proxy(a, metric).error, fit_proxy(all, metric).error, 1e-12);
}

TEST(Proxy, RefusesMetricsThatMeasureNothing) {
  EXPECT_TRUE(check_metric({}));
  for (const ClusterMetric& metric : {ClusterMetric{0, 0, 1}, ClusterMetric{-1, 1, 0},
                                      ClusterMetric{1, NAN, 0}, ClusterMetric{1, 0, INFINITY}}) {
    const auto ok = check_metric(metric);
    ASSERT_FALSE(ok);
    EXPECT_EQ(ok.error().code, ErrorCode::Usage);
  }
}

TEST(Partition, MergesAsAFreshFitWould) {
  const FaceGraph graph = graph_of(make_torus(8, 10));
  const ClusterMetric metric = for_regions({1.0, 0.5, 0.1}, 5);
  for (int a = 0; a < 5; ++a)
    for (int b = 0; b < 5; ++b) {
      if (a == b) continue;
      Partition partition;
      for (int f = 0; f < graph.face_count(); ++f) partition.region_of_face.push_back(f % 5);
      partition.refit(graph, 5, metric);
      const double expected = partition.error + merge_cost(partition, {a, b}, metric);
      partition.merge(a, b, metric);
      EXPECT_NEAR(partition.error, expected, 1e-12);
      Partition fresh = partition;
      fresh.refit(graph, 4, metric);
      EXPECT_NEAR(fresh.error, partition.error, 1e-12);
    }
}

}  // namespace
}  // namespace planewright
