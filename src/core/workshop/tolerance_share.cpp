#include "core/workshop/tolerance_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planewright {
namespace {

constexpr double kMost = 1000.0;
constexpr double kSquareMetres = 1e-6;  // per mm^2
constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

double above(double measured, double limit) {
  return limit > 0.0 ? std::min(measured / limit, kMost) : 0.0;
}
double below(double measured, double limit) {
  return measured > 0.0 ? std::min(limit / measured, kMost) : (limit > 0.0 ? kMost : 0.0);
}

template <class Measure>
double worst_side(const PanelPassport& passport, Measure&& share_of) {
  double worst = 0.0;
  for (const SidePassport& side : passport.sides) worst = std::max(worst, share_of(side));
  return worst;
}

double share(const PanelPassport& passport, const ToleranceSheet& sheet, ToleranceKind kind) {
  const auto fold = [](auto&& share_of) {
    return
        [share_of](const SidePassport& side) { return side.neighbour >= 0 ? share_of(side.dihedral) : 0.0; };
  };
  switch (kind) {
    case ToleranceKind::Planarity:
      return above(passport.planarity, *sheet.planarity);
    case ToleranceKind::Distance:
      return passport.distance ? above(*passport.distance, *sheet.distance) : kUnmeasured;
    case ToleranceKind::EdgeMin:
      return worst_side(passport, [&](const auto& side) { return below(side.length, *sheet.edge_min); });
    case ToleranceKind::EdgeMax:
      return worst_side(passport, [&](const auto& side) { return above(side.length, *sheet.edge_max); });
    case ToleranceKind::AreaMin:
      return below(passport.area * kSquareMetres, *sheet.area_min);
    case ToleranceKind::AreaMax:
      return above(passport.area * kSquareMetres, *sheet.area_max);
    case ToleranceKind::InteriorMin:
      return worst_side(passport,
                        [&](const auto& side) { return below(side.interior, *sheet.interior_min); });
    case ToleranceKind::InteriorMax:
      return worst_side(passport,
                        [&](const auto& side) { return above(side.interior, *sheet.interior_max); });
    case ToleranceKind::DihedralMin:
      return worst_side(passport, fold([&](double angle) { return below(angle, *sheet.dihedral_min); }));
    case ToleranceKind::DihedralMax:
      return worst_side(passport, fold([&](double angle) { return above(angle, *sheet.dihedral_max); }));
    case ToleranceKind::StockSize: {
      const auto [smaller, larger] = std::minmax(sheet.stock->width, sheet.stock->height);
      return std::max(above(passport.width, larger), above(passport.height, smaller));
    }
    case ToleranceKind::CrossesItself:
      break;
  }
  return 0.0;  // the verdict decides
}

}  // namespace

std::vector<ToleranceKind> limited_kinds(const ToleranceSheet& sheet) {
  std::vector<ToleranceKind> kinds;
  const auto add = [&](bool limited, ToleranceKind kind) {
    if (limited) kinds.push_back(kind);
  };
  add(sheet.planarity.has_value(), ToleranceKind::Planarity);
  add(sheet.distance.has_value(), ToleranceKind::Distance);
  add(sheet.edge_min.has_value(), ToleranceKind::EdgeMin);
  add(sheet.edge_max.has_value(), ToleranceKind::EdgeMax);
  add(sheet.area_min.has_value(), ToleranceKind::AreaMin);
  add(sheet.area_max.has_value(), ToleranceKind::AreaMax);
  add(sheet.interior_min.has_value(), ToleranceKind::InteriorMin);
  add(sheet.interior_max.has_value(), ToleranceKind::InteriorMax);
  add(sheet.dihedral_min.has_value(), ToleranceKind::DihedralMin);
  add(sheet.dihedral_max.has_value(), ToleranceKind::DihedralMax);
  add(sheet.stock.has_value(), ToleranceKind::StockSize);
  add(true, ToleranceKind::CrossesItself);
  return kinds;
}

Vector tolerance_shares(const std::vector<PanelPassport>& passports, const ToleranceVerdicts& verdicts,
                        const ToleranceSheet& sheet, std::optional<ToleranceKind> kind) {
  std::vector<ToleranceKind> kinds = limited_kinds(sheet);
  if (kind) std::erase_if(kinds, [&](ToleranceKind limited) { return limited != *kind; });

  std::vector<bool> fails(passports.size(), false);
  for (const ToleranceFailure& failure : verdicts.failures)
    if (!kind || failure.kind == *kind) fails[static_cast<size_t>(failure.panel)] = true;

  Vector shares = Vector::Constant(static_cast<Eigen::Index>(passports.size()), kUnmeasured);
  for (size_t p = 0; p < passports.size(); ++p) {
    double& worst = shares[static_cast<Eigen::Index>(p)];
    for (const ToleranceKind limited : kinds) {
      const double of_kind = share(passports[p], sheet, limited);
      if (!std::isnan(of_kind)) worst = std::isnan(worst) ? of_kind : std::max(worst, of_kind);
    }
    if (std::isnan(worst)) continue;
    worst = fails[p] ? std::max(worst, kLeastFailing) : std::min(worst, kMostPassing);
  }
  return shares;
}

}  // namespace planewright
