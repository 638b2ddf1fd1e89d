#include "core/problem/demands/demand_catalogue.h"

#include "core/problem/demands/border_curve_demand.h"
#include "core/problem/demands/convex_demand.h"
#include "core/problem/demands/coplanar_beams_demand.h"
#include "core/problem/demands/edge_demand.h"
#include "core/problem/demands/face_demand.h"
#include "core/problem/demands/height_band_demand.h"
#include "core/problem/demands/offset_band_demand.h"
#include "core/problem/demands/on_plane_demand.h"
#include "core/problem/demands/prism_demand.h"
#include "core/problem/demands/star_demand.h"
#include "core/problem/demands/uncrossed_demand.h"
#include "core/problem/demands/vertex_demand.h"

namespace planewright {
namespace {

// An end that is not given is none.
std::vector<DemandParameter> band_parameters() {
  return {{"low", "from", DemandUnit::Length, -kUnbounded}, {"high", "to", DemandUnit::Length, kUnbounded}};
}

}  // namespace

const std::vector<DemandInfo>& demand_catalogue() {
  static const std::vector<DemandInfo> catalogue = {
      {"vertex",
       "Corners in front",
       "Every panel corner stays in front of its mesh face.",
       "3",
       true,
       false,
       false,
       {},
       make_vertex_demand},
      {"face",
       "Panels in front",
       "No mesh vertex pokes through its panel.",
       "3",
       true,
       false,
       false,
       {},
       make_face_demand},
      {"edge",
       "Edges in front",
       "No panel edge dips under the mesh edge it crosses.",
       "3",
       true,
       false,
       false,
       {},
       make_edge_demand},
      {"offset-band", "Offset band", "The distance of every panel's plane from the mesh stays in a band.",
       "2.4", true, true, true, band_parameters(), make_offset_band_demand},
      {"height-band", "Height band", "The height of every point over the mesh stays in a band.", "2.4", true,
       true, true, band_parameters(), make_height_band_demand},
      {"prism",
       "Above its face",
       "Every point stays straight above or below its mesh face.",
       "2.4",
       true,
       false,
       false,
       {},
       make_prism_demand},
      {"on-plane",
       "On a plane",
       "The points lie on a given plane, such as a floor slab.",
       "",
       true,
       true,
       true,
       {{"px", "through x", DemandUnit::CoordinateX},
        {"py", "y", DemandUnit::CoordinateY},
        {"pz", "z", DemandUnit::CoordinateZ},
        {"nx", "normal x", DemandUnit::None},
        {"ny", "y", DemandUnit::None},
        {"nz", "z", DemandUnit::None, 1.0}},
       make_on_plane_demand},
      {"border",
       "Border on its curve",
       "The outline of the design stays on its curve.",
       "",
       true,
       true,
       true,
       {},
       make_border_curve_demand},
      {"star",
       "Star-shaped panels",
       "Every panel shows all of its outline to one point inside it.",
       "",
       true,
       true,
       true,
       {{"eps", "least area share", DemandUnit::None, 1e-3}},
       make_star_demand},
      {"uncrossed",
       "Panels uncrossed",
       "No panel crosses itself, and no panel edge turns round.",
       "",
       true,
       true,
       true,
       {{"eps", "least area share", DemandUnit::None, 1e-3},
        {"kappa", "least edge share", DemandUnit::None, 0.1}},
       make_uncrossed_demand},
      {"convex",
       "Convex panels",
       "Every corner of a panel turns the same way.",
       "4.2",
       true,
       true,
       true,
       {{"eps", "least turn", DemandUnit::None, 1e-3}},
       make_convex_demand},
      {"coplanar-beams",
       "Flat beams",
       "A straight flat beam fits between each edge and the other layer's.",
       "4.3",
       true,
       true,
       true,
       {},
       make_coplanar_beams_demand},
  };
  return catalogue;
}

Result<const DemandInfo*> find_demand(const std::string& name) {
  std::string known;
  for (const DemandInfo& info : demand_catalogue()) {
    if (info.name == name) return &info;
    known += (known.empty() ? "" : ", ") + info.name;
  }
  return fail(ErrorCode::Usage, "there is no demand of the name '" + name + "'", "demands",
              "Known: " + known);
}

}  // namespace planewright
