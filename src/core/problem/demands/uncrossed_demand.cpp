#include "core/problem/demands/uncrossed_demand.h"

#include <algorithm>
#include <array>

#include "core/problem/demands/linear_rows.h"
#include "core/problem/demands/star_rows.h"
#include "core/problem/demands/value_checks.h"

namespace planewright {
namespace {

constexpr double kLeastDirected = 1e-3;  // edges

// Four rows per quad, corner by corner.
class DiagonalRows final : public PanelTriangleRows {
 public:
  using PanelTriangleRows::PanelTriangleRows;

  void add_quad(const DemandContext& context, int panel, double eps) {
    const auto corners = context.complex.panels[panel];
    const double size = panel_size(context.complex, panel);
    for (size_t c = 0; c < 4; ++c)
      add(context.layout, panel, corners[(c + 1) % 4], corners[(c + 3) % 4], {{corners[c]}}, 1.0 / size,
          {eps * size, kUnbounded}, {ElementKind::Panel, panel});
  }

  void waive_alternatives(const double* z, std::span<char> waived) const override {
    for (int first = 0; first < rows(); first += 4) {
      std::array<double, 4> corner;
      for (int c = 0; c < 4; ++c) corner[static_cast<size_t>(c)] = value(first + c, z);
      const bool second_pair = std::min(corner[1], corner[3]) > std::min(corner[0], corner[2]);
      const int given_up = first + (second_pair ? 0 : 1);
      waived[static_cast<size_t>(given_up)] = waived[static_cast<size_t>(given_up + 2)] = 1;
    }
  }

 private:
  double value(int row, const double* z) const {
    std::array<double, 12> local;  // three corners and the normal
    std::transform(stencil(row).begin(), stencil(row).end(), local.begin(), [z](int v) { return z[v]; });
    return evaluate(row, local.data(), nullptr, nullptr);
  }
};

std::unique_ptr<Constraint> direction_rows(const DemandContext& context, double kappa) {
  const TangentComplex& complex = context.complex;
  const Layout& layout = context.layout;
  auto rows = std::make_unique<LinearRows>("uncrossed", "edges");
  const auto selected = [&](int panel) {
    return panel >= 0 && context.where.panels[static_cast<size_t>(panel)];
  };
  for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    if (!selected(edge.left) && !selected(edge.right)) continue;
    const Vector3d along = complex.preferred.row(edge.b) - complex.preferred.row(edge.a);
    const double length = along.norm();
    if (!(length >= kLeastDirected)) continue;
    const Vector3d d = along / length;
    rows->add(std::array{layout.x(edge.a, 0), layout.x(edge.a, 1), layout.x(edge.a, 2), layout.x(edge.b, 0),
                         layout.x(edge.b, 1), layout.x(edge.b, 2)},
              std::array{-d[0], -d[1], -d[2], d[0], d[1], d[2]}, {kappa * length, kUnbounded},
              {ElementKind::PanelEdge, static_cast<int>(e)});
  }
  return rows;
}

}  // namespace

Result<Constraints> make_uncrossed_demand(const DemandContext& context) {
  const double eps = context.values[0], kappa = context.values[1];
  if (auto sound = check_share("uncrossed", "eps", eps); !sound) return tl::unexpected(sound.error());
  if (auto sound = check_share("uncrossed", "kappa", kappa); !sound) return tl::unexpected(sound.error());
  auto diagonals = std::make_unique<DiagonalRows>("uncrossed", "edges");
  auto stars = std::make_unique<PanelTriangleRows>("uncrossed", "edges");
  for (int i = 0; i < context.complex.panels.size(); ++i) {
    if (!context.where.panels[static_cast<size_t>(i)]) continue;
    const int corners = context.complex.panels.valence(i);
    if (corners == 4) diagonals->add_quad(context, i, eps);
    if (corners >= 5) add_star_rows(context, i, eps, *stars);
  }
  Constraints constraints;
  constraints.push_back(std::move(diagonals));
  constraints.push_back(std::move(stars));
  constraints.push_back(direction_rows(context, kappa));
  return constraints;
}

}  // namespace planewright
