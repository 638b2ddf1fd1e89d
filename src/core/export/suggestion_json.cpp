#include "core/export/suggestion_json.h"

namespace planewright {
namespace {

Json score_json(const Score& score) {
  return {{"total", total(score)},      {"energy", score.energy},
          {"crossing", score.crossing}, {"short_edges", score.short_edges},
          {"reversed", score.reversed}, {"far_points", score.far_points}};
}

}  // namespace

Json suggestions_json(const std::vector<Suggestion>& ranked, const PolygonMesh& mesh) {
  Json list = Json::array();
  for (const Suggestion& suggestion : ranked) {
    const Candidate& candidate = suggestion.candidate;
    const MeshEdge edge = mesh.edge(candidate.mesh_edge);
    const Vector3d middle = 0.5 * (mesh.positions().row(edge.a) + mesh.positions().row(edge.b)).transpose();
    const GainParts parts = suggestion.parts();
    Json entry = {{"edit", name(candidate.edit.kind)},
                  {"element", candidate.edit.element},
                  {"edge", candidate.mesh_edge},
                  {"vertices", {edge.a, edge.b}},
                  {"place", {middle.x(), middle.y(), middle.z()}},
                  {"gain", suggestion.gain()},
                  {"parts",
                   {{"energy", parts.energy},
                    {"crossing", parts.crossing},
                    {"short_edges", parts.short_edges},
                    {"reversed", parts.reversed},
                    {"far_points", parts.far_points},
                    {"deviation", parts.deviation},
                    {"given_up", parts.given_up}}},
                  {"met", suggestion.met}};
    if (candidate.edit.to) {
      const Vector3d& to = *candidate.edit.to;
      entry["to"] = {to.x(), to.y(), to.z()};
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Json measure_json(const DesignMeasure& measure) {
  Json counts = Json::object();
  for (const FindingKind kind : all_finding_kinds())
    counts[info(kind).name] = measure.findings[static_cast<size_t>(kind)];
  return {{"panels", measure.panels},
          {"points", measure.points},
          {"unbuildable", measure.unbuildable()},
          {"counts", counts},
          {"score", score_json(measure.score)}};
}

}  // namespace planewright
