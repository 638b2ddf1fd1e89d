#include "core/certify/class_checks.h"

#include <algorithm>
#include <cmath>

#include "core/certify/check_text.h"
#include "core/certify/panel_outline.h"

namespace planewright {
namespace {

// By how much distances of a member differ from the mother's at most; infinite where corners do not pair.
double difference_of_distances(const Contour& mother, const Contour& member, const CongruenceMember& how) {
  const Eigen::Index n = mother.rows();
  if (member.rows() != n || how.shift < 0 || how.shift >= n) return std::numeric_limits<double>::infinity();
  const auto on = [&](Eigen::Index k) {
    return how.mirrored ? (how.shift + n - k) % n : (how.shift + k) % n;
  };
  double largest = 0.0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = i + 1; k < n; ++k)
      largest = std::max(largest, std::abs((mother.row(i) - mother.row(k)).norm() -
                                           (member.row(on(i)) - member.row(on(k))).norm()));
  return largest;
}

bool bevels_allow(const PanelPassport& mother, const PanelPassport& member, const CongruenceMember& how,
                  double limit) {
  const size_t n = mother.sides.size();
  if (member.sides.size() != n) return false;
  for (size_t k = 0; k < n; ++k) {
    const double a = mother.sides[k].bevel, b = member.sides[(static_cast<size_t>(how.shift) + k) % n].bevel;
    // Turned over, a mitre leans the wrong way.
    if (how.mirrored ? !(std::max(std::abs(a), std::abs(b)) <= limit) : !(std::abs(a - b) <= limit))
      return false;
  }
  return true;
}

double size_of(const Contour& outline) {
  return outline.rows() > 0 ? outline.rowwise().norm().maxCoeff() : 0.0;
}

}  // namespace

Check check_classes(const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  const double limit = 2.0 * content.congruence.tolerance;
  // What rounding can do to lengths, and to angles of acos.
  constexpr double kRounding = 1e-9, kAngles = 1e-6;
  std::vector<int> times(static_cast<size_t>(model.panel_count()), 0);
  std::vector<std::string> wrong;
  long long laid = 0;
  double largest = 0.0;
  for (const CongruenceClass& group : *content.classes) {
    if (group.members.empty()) {
      wrong.push_back("a class of no panel");
      continue;
    }
    for (const CongruenceMember& m : group.members)
      if (m.panel >= 0 && m.panel < model.panel_count()) ++times[static_cast<size_t>(m.panel)];
    const CongruenceMember& first = group.members.front();
    const Contour mother = outline_in_plane(model, first.panel);
    if (first.mirrored || first.shift != 0) wrong.push_back(model.names[static_cast<size_t>(first.panel)]);
    for (size_t i = 1; i < group.members.size(); ++i) {
      const CongruenceMember& m = group.members[i];
      ++laid;
      const double off = difference_of_distances(mother, outline_in_plane(model, m.panel), m);
      if (std::isfinite(off)) largest = std::max(largest, off);
      const bool bevels =
          !content.congruence.bevels || bevels_allow((*content.passports)[static_cast<size_t>(first.panel)],
                                                     (*content.passports)[static_cast<size_t>(m.panel)], m,
                                                     content.congruence.bevel_tolerance + kAngles);
      if (!(off <= limit + kRounding * size_of(mother)) || !bevels)
        wrong.push_back(model.names[static_cast<size_t>(m.panel)]);
    }
  }
  for (size_t p = 0; p < times.size(); ++p)
    if (times[p] != 1) wrong.push_back(model.names[p] + " in " + std::to_string(times[p]) + " classes");
  std::string detail =
      counted(static_cast<long long>(content.classes->size())) + " classes, " + counted(laid) +
      " panels laid on others, distances between corners: " + against_limit(largest, limit, "mm");
  if (!wrong.empty()) detail += "; wrong: " + listed(wrong);
  return {"classes of congruent panels", wrong.empty(), detail};
}

}  // namespace planewright
