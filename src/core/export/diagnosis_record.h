// DiagnosisRecord: what `planewright-cli diagnose` says of one layer, and its JSON form with the keys of
// docs/command-line.md. Lengths in model units unless a name says otherwise.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/advise/advisor.h"
#include "core/diagnose/diagnosis.h"
#include "core/mesh/health_report.h"
#include "core/solve/solve_report.h"

namespace planewright {

struct DiagnosisRecord {
  std::string layer;  // its name; empty: the only one
  std::shared_ptr<const TangentComplex> complex;
  std::optional<SolveReport> solve;  // none: the panels were taken as they are
  Diagnosis diagnosis;
  // Edits of the mesh that would better it, ranked; none: nothing was rated, `unrated` may say why.
  std::optional<std::vector<Suggestion>> suggestions;
  std::string unrated;
};

// Of all layers of one design of this mesh, at least one; several, or one with a name, are a list "layers".
std::string to_json(const std::string& input, const PolygonMesh& mesh,
                    const std::vector<DiagnosisRecord>& layers, const HealthReport& health);

}  // namespace planewright
