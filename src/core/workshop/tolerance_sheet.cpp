#include "core/workshop/tolerance_sheet.h"

#include <algorithm>
#include <limits>

#include "core/workshop/measure_slack.h"
#include "core/workshop/panel_plane.h"
#include "core/workshop/panel_rectangle.h"

namespace planewright {
namespace {

constexpr double kSquareMetres = 1e-6;  // per mm^2

// The checks of one panel; failures come by kind, then side, because they are asked for in that order.
class PanelCheck {
 public:
  PanelCheck(const WorkshopModel& model, const std::vector<PanelPassport>& passports, int panel,
             double resolution, std::vector<ToleranceFailure>& failures)
      : model_(model),
        passports_(passports),
        passport_(passports[static_cast<size_t>(panel)]),
        panel_(panel),
        resolution_(resolution),
        failures_(failures) {}

  void run(const ToleranceSheet& sheet) {
    at_most(ToleranceKind::Planarity, -1, passport_.planarity, sheet.planarity, resolution_);
    if (passport_.distance)
      at_most(ToleranceKind::Distance, -1, *passport_.distance, sheet.distance, resolution_);
    each_side([&](int k, const SidePassport& side) {
      at_least(ToleranceKind::EdgeMin, k, side.length, sheet.edge_min, resolution_);
    });
    each_side([&](int k, const SidePassport& side) {
      at_most(ToleranceKind::EdgeMax, k, side.length, sheet.edge_max, resolution_);
    });
    const double area = passport_.area * kSquareMetres;
    const double area_slack = resolution_ * passport_.perimeter * kSquareMetres;
    at_least(ToleranceKind::AreaMin, -1, area, sheet.area_min, area_slack);
    at_most(ToleranceKind::AreaMax, -1, area, sheet.area_max, area_slack);
    each_side([&](int k, const SidePassport& side) {
      at_least(ToleranceKind::InteriorMin, k, side.interior, sheet.interior_min, corner_slack(k));
    });
    each_side([&](int k, const SidePassport& side) {
      at_most(ToleranceKind::InteriorMax, k, side.interior, sheet.interior_max, corner_slack(k));
    });
    each_side([&](int k, const SidePassport& side) {
      if (side.neighbour >= 0)
        at_least(ToleranceKind::DihedralMin, k, side.dihedral, sheet.dihedral_min, fold_slack(side));
    });
    each_side([&](int k, const SidePassport& side) {
      if (side.neighbour >= 0)
        at_most(ToleranceKind::DihedralMax, k, side.dihedral, sheet.dihedral_max, fold_slack(side));
    });
    if (sheet.stock) check_stock(*sheet.stock);
    if (passport_.crosses_itself) failures_.push_back({panel_, ToleranceKind::CrossesItself, -1, 1.0, 0.0});
  }

 private:
  template <class Visit>
  void each_side(Visit&& visit) {
    for (size_t k = 0; k < passport_.sides.size(); ++k) visit(static_cast<int>(k), passport_.sides[k]);
  }

  void at_most(ToleranceKind kind, int side, double measured, const std::optional<double>& limit,
               double slack) {
    if (limit && !(measured <= *limit + kRelativeSlack * std::abs(*limit) + slack))
      failures_.push_back({panel_, kind, side, measured, *limit});
  }
  void at_least(ToleranceKind kind, int side, double measured, const std::optional<double>& limit,
                double slack) {
    if (limit && !(measured >= *limit - kRelativeSlack * std::abs(*limit) - slack))
      failures_.push_back({panel_, kind, side, measured, *limit});
  }

  double corner_slack(int k) const {
    const size_t n = passport_.sides.size(), here = static_cast<size_t>(k);
    return angle_slack(resolution_,
                       std::min(passport_.sides[here].length, passport_.sides[(here + n - 1) % n].length));
  }
  double fold_slack(const SidePassport& side) const {
    return angle_slack(resolution_,
                       std::min(passport_.height, passports_[static_cast<size_t>(side.neighbour)].height));
  }

  void check_stock(const SheetSize& stock) {
    const double larger = std::max(stock.width, stock.height), smaller = std::min(stock.width, stock.height);
    const auto outline = flat_outline(model_.points, model_.panels[panel_], model_.normals.row(panel_));
    if (fits_rectangle(outline, stock.width, stock.height, kRelativeSlack * larger + resolution_)) return;
    // Of its smallest rectangle the side that is too big by more; if it doesn't fit, one of them is.
    const bool width = passport_.width * smaller >= passport_.height * larger;
    failures_.push_back({panel_, ToleranceKind::StockSize, -1, width ? passport_.width : passport_.height,
                         width ? larger : smaller});
  }

  const WorkshopModel& model_;
  const std::vector<PanelPassport>& passports_;
  const PanelPassport& passport_;
  int panel_;
  double resolution_;
  std::vector<ToleranceFailure>& failures_;
};

}  // namespace

ToleranceVerdicts check_tolerances(const WorkshopModel& model, const std::vector<PanelPassport>& passports,
                                   const ToleranceSheet& sheet) {
  const double resolution = coordinate_resolution(model);
  ToleranceVerdicts verdicts;
  for (int p = 0; p < model.panel_count(); ++p) {
    const size_t before = verdicts.failures.size();
    PanelCheck(model, passports, p, resolution, verdicts.failures).run(sheet);
    const bool pass = verdicts.failures.size() == before;
    verdicts.pass.push_back(pass);
    ++(pass ? verdicts.passed : verdicts.failed);
  }
  return verdicts;
}

}  // namespace planewright
