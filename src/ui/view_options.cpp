#include "ui/view_options.h"

namespace planewright::ui {

const char* name(ColourMap map) {
  switch (map) {
    case ColourMap::None:
      return "none";
    case ColourMap::Planarity:
      return "planarity";
    case ColourMap::Displacement:
      return "displacement";
    case ColourMap::Findings:
      return "findings";
    case ColourMap::Tolerances:
      return "tolerances";
  }
  return "";
}

const char* name(ClusterSight sight) {
  switch (sight) {
    case ClusterSight::Regions:
      return "regions";
    case ClusterSight::Panels:
      return "panels";
    case ClusterSight::Beside:
      return "beside";
    case ClusterSight::Over:
      return "over";
  }
  return "";
}

const char* name(Tool tool) {
  switch (tool) {
    case Tool::Look:
      return "look";
    case Tool::Box:
      return "box";
    case Tool::Split:
      return "split";
    case Tool::Merge:
      return "merge";
    case Tool::Paint:
      return "paint";
  }
  return "";
}

}  // namespace planewright::ui
