// The catalogue of demands: one entry per demand, in the order in which the window and reports list them. A
// new demand is its own small file and one entry here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/problem/constraint.h"
#include "core/problem/demands/demand_context.h"

namespace planewright {

// What a value of a demand is measured in. Lengths and coordinates are model units for people and mean edges
// for constraints; a coordinate is also shifted to the complex's centre.
enum class DemandUnit { Length, CoordinateX, CoordinateY, CoordinateZ, Edges, None };

struct DemandParameter {
  std::string name;   // "low"
  std::string label;  // "from"
  DemandUnit unit = DemandUnit::Length;
  double default_value = 0.0;
};

using Constraints = std::vector<std::unique_ptr<Constraint>>;

struct DemandInfo {
  std::string name;         // "offset-band": the key of reports and the command line
  std::string label;        // "Offset band"
  std::string description;  // one sentence for a designer
  std::string source;       // paper section
  bool for_dual, for_planarize, for_cluster;
  std::vector<DemandParameter> parameters;
  // Fails with ErrorCode::Usage or Infeasible: values that make no sense (an empty band), no neighbour layer.
  Result<Constraints> (*make)(const DemandContext& context);
  bool fits(ComplexKind kind) const {
    return kind == ComplexKind::Dual        ? for_dual
           : kind == ComplexKind::Planarize ? for_planarize
                                            : for_cluster;
  }
};

const std::vector<DemandInfo>& demand_catalogue();

// Fails with ErrorCode::Usage and the known names.
Result<const DemandInfo*> find_demand(const std::string& name);

}  // namespace planewright
