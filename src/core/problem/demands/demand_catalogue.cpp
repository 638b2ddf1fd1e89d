#include "core/problem/demands/demand_catalogue.h"

#include "core/problem/demands/edge_demand.h"
#include "core/problem/demands/face_demand.h"
#include "core/problem/demands/vertex_demand.h"

namespace planewright {

const std::vector<DemandInfo>& demand_catalogue() {
  static const std::vector<DemandInfo> catalogue = {
      {"vertex", "Corners in front", "Every panel corner stays in front of its mesh face.", "3", true, false, {},
       make_vertex_demand},
      {"face", "Panels in front", "No mesh vertex pokes through its panel.", "3", true, false, {}, make_face_demand},
      {"edge", "Edges in front", "No panel edge dips under the mesh edge it crosses.", "3", true, false, {},
       make_edge_demand},
  };
  return catalogue;
}

Result<const DemandInfo*> find_demand(const std::string& name) {
  std::string known;
  for (const DemandInfo& info : demand_catalogue()) {
    if (info.name == name) return &info;
    known += (known.empty() ? "" : ", ") + info.name;
  }
  return fail(ErrorCode::Usage, "there is no demand of the name '" + name + "'", "demands", "Known: " + known);
}

}  // namespace planewright
