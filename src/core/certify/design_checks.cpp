#include "core/certify/design_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/certify/check_text.h"
#include "core/certify/class_checks.h"
#include "core/certify/exact_signs.h"
#include "core/certify/panel_outline.h"
#include "core/certify/part_checks.h"
#include "core/certify/solid_pairs.h"
#include "core/certify/solid_shape.h"

namespace planewright {
namespace {

// Of mm^2, as schedules have them.
std::string square_metres(double area) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", area * 1e-6);
  return text;
}

constexpr double kLengthLimit = 1e-6;  // mm
constexpr double kAreaLimit = 1e-9;    // relative

const std::string& name(const WorkshopModel& model, int panel) {
  return model.names[static_cast<size_t>(panel)];
}

Check planarity(const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  double largest = 0.0, off = 0.0;
  for (int p = 0; p < model.panel_count(); ++p) {
    double deviation = 0.0;
    for (const int c : model.panels[p])
      deviation = std::max(deviation,
                           std::abs(model.points.row(c).dot(model.normals.row(p)) - model.plane_offsets[p]));
    largest = std::max(largest, deviation);
    off = std::max(off, std::abs(deviation - (*content.passports)[static_cast<size_t>(p)].planarity));
  }
  std::vector<std::string> beyond;
  for (const ToleranceFailure& f : content.verdicts->failures)
    if (f.kind == ToleranceKind::Planarity) beyond.push_back(name(model, f.panel));
  std::string detail = counted(model.panel_count()) + " panels, largest " + brief(largest) +
                       " mm, passports agree: " + against_limit(off, kLengthLimit, "mm");
  if (!beyond.empty()) detail += "; beyond the tolerance: " + listed(beyond);
  return {"planarity", beyond.empty() && off <= kLengthLimit, detail};
}

Check simple_polygons(const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  std::vector<std::string> crossing, backwards;
  for (int p = 0; p < model.panel_count(); ++p) {
    const Contour outline = outline_in_plane(model, p);
    if (!is_simple(outline))
      crossing.push_back(name(model, p));
    else if (area_sign(outline) <= 0)
      backwards.push_back(name(model, p));
  }
  std::string detail = counted(model.panel_count()) + " panels, exact";
  if (!crossing.empty()) detail += "; crossing themselves: " + listed(crossing);
  if (!backwards.empty()) detail += "; against their normal: " + listed(backwards);
  return {"simple polygons", crossing.empty() && backwards.empty(), detail};
}

Check equal_lengths(const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  double largest = 0.0;
  long long compared = 0;
  std::vector<std::string> wrong;
  const auto length = [&](int panel, int side) {
    const Contour& c = (*content.patterns)[static_cast<size_t>(panel)].nominal;
    if (c.rows() != model.panels.valence(panel)) return -1.0;
    return (c.row((side + 1) % c.rows()) - c.row(side)).norm();
  };
  for (const WorkshopEdge& e : model.edges) {
    if (e.border()) continue;
    const double left = length(e.left, e.left_side), right = length(e.right, e.right_side);
    if (left < 0.0 || right < 0.0) continue;  // a panel without pattern, which its own checks name
    ++compared;
    largest = std::max(largest, std::abs(left - right));
    if (!(std::abs(left - right) <= kLengthLimit))
      wrong.push_back(name(model, e.left) + "/" + name(model, e.right));
  }
  return {"equal lengths of shared edges", wrong.empty(),
          counted(compared) + " edges in both patterns, " + against_limit(largest, kLengthLimit, "mm") +
              (wrong.empty() ? "" : "; different: " + listed(wrong))};
}

Check areas(const ExportContent& content) {
  double patterns = 0.0, panels = 0.0;
  int compared = 0;
  for (size_t p = 0; p < content.patterns->size(); ++p) {
    const Contour& c = (*content.patterns)[p].nominal;
    if (c.rows() < 3) continue;
    ++compared;
    for (Eigen::Index i = 1; i + 1 < c.rows(); ++i) {
      const Eigen::RowVector2d a = c.row(i) - c.row(0), b = c.row(i + 1) - c.row(0);
      patterns += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    panels += 0.5 * newell_vector(content.model->points, content.model->panels[static_cast<int>(p)]).norm();
  }
  const double difference = panels > 0.0 ? std::abs(patterns / panels - 1.0) : std::abs(patterns);
  return {"areas of patterns and panels", difference <= kAreaLimit,
          counted(compared) + " patterns, " + square_metres(panels) + " m², difference " + brief(difference) +
              " of it (limit " + brief(kAreaLimit) + ")"};
}

void solid_checks(const ExportContent& content, std::vector<Check>& checks) {
  const WorkshopModel& model = *content.model;
  std::vector<std::string> open, empty_inside;
  long long there = 0;
  for (const ThickPanel& s : content.solids->panels) {
    if (s.empty()) continue;
    ++there;
    const std::vector<int> all = all_of(s.faces);
    std::vector<int> as_they_are(static_cast<size_t>(s.points.rows()));
    for (size_t i = 0; i < as_they_are.size(); ++i) as_they_are[i] = static_cast<int>(i);
    if (!is_closed(s.faces, all, as_they_are)) open.push_back(name(model, s.panel));
    if (volume_sign(s.points, fans(s.faces, all)) <= 0) empty_inside.push_back(name(model, s.panel));
  }
  const std::string each = counted(there) + " solids";
  checks.push_back({"closed solids", open.empty(),
                    open.empty() ? each + ", every edge once each way" : "open: " + listed(open)});
  checks.push_back({"positive volumes", empty_inside.empty(),
                    empty_inside.empty() ? each + ", exact sign" : "not positive: " + listed(empty_inside)});
  const SolidPairs pairs = examine_pairs(model, *content.solids, kLengthLimit);
  std::vector<std::string> penetrating;
  for (const auto& [a, b] : pairs.penetrating) penetrating.push_back(name(model, a) + "/" + name(model, b));
  std::string detail = counted(pairs.parted_by_mitre) + " pairs parted by their mitre plane, " +
                       counted(pairs.parted_by_face) + " by a face, " + counted(pairs.tested) +
                       " tested triangle by triangle; exact signs, tolerance " + brief(kLengthLimit) + " mm";
  if (!penetrating.empty()) detail += "; penetrating: " + listed(penetrating);
  checks.push_back({"no penetrating solids", penetrating.empty(), detail});
}

}  // namespace

std::vector<Check> check_design(const ExportContent& content) {
  std::vector<Check> checks{planarity(content), simple_polygons(content)};
  if (content.patterns) {
    checks.push_back(equal_lengths(content));
    checks.push_back(areas(content));
  }
  if (content.classes) checks.push_back(check_classes(content));
  if (!content.drawings.empty())
    for (Check& check : check_parts(content)) checks.push_back(std::move(check));
  if (content.solids) solid_checks(content, checks);
  return checks;
}

}  // namespace planewright
