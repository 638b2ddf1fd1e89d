#include "core/cluster/border_anchors.h"

#include <algorithm>

namespace planewright {
namespace {

struct Farthest {
  size_t at;
  double distance;
};

Farthest farthest_from_chord(const FaceGraph& graph, const std::vector<int>& chain, size_t from, size_t to) {
  const Vector3d a = graph.vertices.row(chain[from]), b = graph.vertices.row(chain[to]);
  const Vector3d along = b - a;
  const double length = along.squaredNorm();
  Farthest farthest{from, -1.0};
  for (size_t k = from + 1; k < to; ++k) {
    const Vector3d arm = graph.vertices.row(chain[k]).transpose() - a;
    const double t = length > 0.0 ? std::clamp(arm.dot(along) / length, 0.0, 1.0) : 0.0;
    const double distance = (arm - t * along).norm();
    if (distance > farthest.distance) farthest = {k, distance};
  }
  return farthest;
}

}  // namespace

void add_border_anchors(const FaceGraph& graph, const std::vector<int>& chain, double tolerance, int least,
                        std::vector<int>& anchors) {
  // The chord that is worst is cut first.
  struct Piece {
    size_t from, to;
    Farthest farthest;
  };
  std::vector<Piece> pieces;
  const auto add = [&](size_t from, size_t to) {
    if (to - from > 1) pieces.push_back({from, to, farthest_from_chord(graph, chain, from, to)});
  };
  const auto worse = [](const Piece& a, const Piece& b) {
    return a.farthest.distance != b.farthest.distance ? a.farthest.distance < b.farthest.distance
                                                      : a.from > b.from;
  };
  add(0, chain.size() - 1);
  int added = 0;
  while (!pieces.empty()) {
    const auto worst = std::max_element(pieces.begin(), pieces.end(), worse);
    const Piece piece = *worst;
    if (!(piece.farthest.distance > tolerance) && added >= least) return;
    pieces.erase(worst);
    anchors.push_back(chain[piece.farthest.at]);
    ++added;
    add(piece.from, piece.farthest.at);
    add(piece.farthest.at, piece.to);
  }
}

}  // namespace planewright
