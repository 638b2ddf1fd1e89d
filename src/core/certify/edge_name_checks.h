// Names along the sides of parts: whether each stands where it says the truth. Internal to certify/. Threads:
// pure.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/certify/placed_parts.h"
#include "core/certify/read_drawing.h"

namespace planewright {

class EdgeNames {
 public:
  // left_out_below: names along sides that the drawing has smaller than this must not be there. slack: by how
  // much another side may be nearer than the one that is named. Both mm of the drawing. All have to outlive
  // it.
  EdgeNames(const Drawing& drawing, const ExportContent& content, double left_out_below, double slack);

  // Panel of the part that has the place inside its contour; -1: none.
  int panel_at(const Eigen::Vector2d& at) const;
  // A text along a side. panel: of the part, as the format says it; empty: it does not.
  void found(const std::string& text, const Eigen::Vector2d& at, const std::string& panel = {});

  // What is wrong: outside every part, not of a neighbour, nearer to another side, missing, too many.
  std::vector<std::string> wrong() const;
  long long wanted() const { return wanted_; }                      // names that have to be there
  long long left_out() const { return left_out_; }                  // that must not
  const std::vector<std::string>& notes() const { return notes_; }  // the drawing's texts that are no names

 private:
  struct Part {
    PlacedPattern placed;
    Eigen::Vector2d low, high;
  };
  const Part* part_at(const Eigen::Vector2d& at) const;
  std::string fault(const Part& part, const std::string& name, const Eigen::Vector2d& at) const;
  bool is_neighbour(int panel, const std::string& name) const;

  const ExportContent& content_;
  double slack_, widest_ = 0.0;
  std::vector<Part> parts_;  // by their left
  std::vector<std::string> faults_, notes_;
  std::map<std::pair<int, std::string>, int> missing_;  // by panel and name; below 0: too many
  long long wanted_ = 0, left_out_ = 0;
};

// Of a DXF or SVG file: its texts on TEXT_EDGES are the edge names and notes of the drawing, each where it
// should be.
Check check_edge_names(const ReadDrawing& read, const Drawing& drawing, const ExportContent& content);

}  // namespace planewright
