#include "core/certify/edge_name_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/certify/border_distance.h"
#include "core/certify/check_text.h"
#include "core/certify/exact_signs.h"

namespace planewright {

using Eigen::Vector2d;

EdgeNames::EdgeNames(const Drawing& drawing, const ExportContent& content, double left_out_below,
                     double slack)
    : content_(content), slack_(slack) {
  for (const PlacedPattern& placed : placed_patterns(drawing, content.patterns)) {
    const Contour& c = placed.line->points;
    parts_.push_back({placed, c.colwise().minCoeff(), c.colwise().maxCoeff()});
    widest_ = std::max(widest_, parts_.back().high.x() - parts_.back().low.x());
  }
  std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.low.x() < b.low.x(); });
  const std::set<std::string> names(content.model->names.begin(), content.model->names.end());
  for (const DrawingText& t : drawing.texts) {
    if (t.is_name) continue;
    if (t.panel >= 0 && names.contains(t.text) && !is_neighbour(t.panel, t.text))
      faults_.push_back(t.text + " on " + content.model->names[static_cast<size_t>(t.panel)] +
                        ": no neighbour");
    if (t.panel < 0 || !is_neighbour(t.panel, t.text)) {
      notes_.push_back(t.text);
    } else if (t.height < left_out_below) {
      ++left_out_;
    } else {
      ++wanted_;
      ++missing_[{t.panel, t.text}];
    }
  }
}

bool EdgeNames::is_neighbour(int panel, const std::string& name) const {
  const auto& sides = (*content_.passports)[static_cast<size_t>(panel)].sides;
  return std::any_of(sides.begin(), sides.end(), [&](const SidePassport& side) {
    return side.neighbour >= 0 && content_.model->names[static_cast<size_t>(side.neighbour)] == name;
  });
}

const EdgeNames::Part* EdgeNames::part_at(const Vector2d& at) const {
  auto part = std::upper_bound(parts_.begin(), parts_.end(), at.x(),
                               [](double x, const Part& p) { return x < p.low.x(); });
  while (part != parts_.begin() && (--part)->low.x() >= at.x() - widest_)
    if ((at - part->low).minCoeff() >= 0.0 && (part->high - at).minCoeff() >= 0.0 &&
        covers(part->placed.line->points, at))
      return &*part;
  return nullptr;
}

int EdgeNames::panel_at(const Vector2d& at) const {
  const Part* part = part_at(at);
  return part ? part->placed.line->panel : -1;
}

// Against the outer face's sides: it is on that face that names are read. Where it is not what is cut (its
// neighbours lean outwards), it is engraved, and the name has to be inside it as well.
std::string EdgeNames::fault(const Part& part, const std::string& name, const Vector2d& at) const {
  const int panel = part.placed.line->panel;
  if (!is_neighbour(panel, name)) return "no neighbour";
  const FlatPattern* pattern = part.placed.pattern;
  if (!pattern || !std::isfinite(part.placed.difference)) return {};
  const Vector2d p = part.placed.motion.inverse() * at;
  const Contour& outer = pattern->outer;
  if (!covers(outer, p)) return "off the outer face";
  double named = std::numeric_limits<double>::infinity(), nearest = named;
  for (Eigen::Index k = 0; k < outer.rows(); ++k) {
    const int side = static_cast<size_t>(k) < pattern->side_of_segment.size()
                         ? pattern->side_of_segment[static_cast<size_t>(k)]
                         : -1;
    if (side < 0) continue;
    const double distance = to_segment(p, outer.row(k), outer.row((k + 1) % outer.rows()));
    nearest = std::min(nearest, distance);
    const int neighbour =
        (*content_.passports)[static_cast<size_t>(panel)].sides[static_cast<size_t>(side)].neighbour;
    if (neighbour >= 0 && content_.model->names[static_cast<size_t>(neighbour)] == name)
      named = std::min(named, distance);
  }
  return std::isfinite(named) && named <= nearest + slack_ ? "" : "nearer to another side";
}

void EdgeNames::found(const std::string& text, const Vector2d& at, const std::string& panel) {
  const Part* part = part_at(at);
  if (!part) {
    faults_.push_back(text + (panel.empty() ? "" : " of " + panel) + " is on no part");
    return;
  }
  const std::string& own = content_.model->names[static_cast<size_t>(part->placed.line->panel)];
  std::string what = fault(*part, text, at);
  if (what.empty() && !panel.empty() && panel != own) what = "said to be on " + panel;
  if (!what.empty()) faults_.push_back(text + " on " + own + ": " + what);
  --missing_[{part->placed.line->panel, text}];
}

std::vector<std::string> EdgeNames::wrong() const {
  std::vector<std::string> all = faults_;
  for (const auto& [key, count] : missing_)
    if (count != 0)
      all.push_back(key.second + " on " + content_.model->names[static_cast<size_t>(key.first)] +
                    (count > 0 ? " is missing" : " is too many"));
  return all;
}

Check check_edge_names(const ReadDrawing& read, const Drawing& drawing, const ExportContent& content) {
  constexpr double kSlack = 1e-6;  // mm
  EdgeNames names(drawing, content, 0.0, kSlack);
  std::map<std::string, int> notes;
  for (const std::string& note : names.notes()) ++notes[note];
  for (const ReadText& t : read.texts) {
    if (t.layer != "TEXT_EDGES") continue;
    if (const auto note = notes.find(t.text); note != notes.end())
      --note->second;
    else
      names.found(t.text, t.at, t.panel);
  }
  std::vector<std::string> wrong = names.wrong();
  for (const auto& [note, count] : notes)
    if (count != 0) wrong.push_back("'" + note + "'" + (count > 0 ? " is missing" : " is too many"));
  std::string detail = counted(names.wanted()) +
                       " names, inside their contours (exact), each nearest to the "
                       "side of its neighbour";
  if (!names.notes().empty())
    detail += "; " + counted(static_cast<long long>(names.notes().size())) + " notes";
  if (!wrong.empty()) detail += "; wrong: " + listed(wrong);
  return {"edge names", wrong.empty(), detail};
}

}  // namespace planewright
