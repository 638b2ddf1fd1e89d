#include "goals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "models.h"

namespace planewright::bench {
namespace {

constexpr double kAgree = 0.01;           // of the energy
constexpr double kMostMemoryMb = 1536.0;  // of 100,000 panels

// Null if that row was not measured.
const MeasuredRow* find(const Comparison& rows, const std::string& model, Contender contender) {
  const auto found = rows.find({model, contender});
  return found == rows.end() ? nullptr : &found->second;
}
bool finished(const MeasuredRow* row) {
  return row && row->end == ChildEnd::Finished;
}

const char* met(bool yes) {
  return yes ? "met" : "MISSED";
}

// Whether times to where both ended may be compared, and if not, why.
std::string comparable(const std::string& model, const Measurement& tangent, const MeasuredRow& other) {
  if (tangent.status != SolveStatus::Converged) return "tangent did not converge";
  if (!(tangent.residual <= kAfterProjection * find_model(model).tolerance))
    return "tangent's residual is too large";
  if (other.end == ChildEnd::Finished && tangent.energy > (1.0 + kAgree) * other.value.energy)
    return "tangent's energy is higher";
  return {};
}

// `slow` against tangent: CPU and wall time both have to be `wanted` times as long.
void print_ratio(const Comparison& rows, const std::string& model, Contender slow, double wanted) {
  std::printf("%-13s tangent against %-14s", model.c_str(), label(slow));
  const MeasuredRow *tangent = find(rows, model, Contender::Tangent), *other = find(rows, model, slow);
  if (!finished(tangent) || !other || (other->end != ChildEnd::Finished && other->end != ChildEnd::CutOff)) {
    std::printf(" not measured (>= %g x)\n", wanted);
    return;
  }
  const bool cut_off = other->end == ChildEnd::CutOff;
  const double cpu = (cut_off ? other->usage.cpu : other->value.cpu) / tangent->value.cpu;
  const double wall = (cut_off ? other->usage.wall : other->value.wall) / tangent->value.wall;
  const bool reached = std::min(cpu, wall) >= wanted;
  std::string verdict = comparable(model, tangent->value, *other);
  if (verdict.empty()) verdict = !reached && cut_off ? "open: the other was cut off" : met(reached);
  if (!cut_off && other->value.status != SolveStatus::Converged) verdict += "; the other did not converge";
  const char* bound = cut_off ? ">= " : "";
  std::printf(" %s%.1f x CPU, %s%.1f x wall (>= %g x): %s\n", bound, cpu, bound, wall, wanted,
              verdict.c_str());
}

// The same stationary state, or merely one that is as stationary?
void print_energies(const Comparison& rows, const std::string& model) {
  std::vector<std::pair<double, Contender>> energies;
  for (const Contender contender : all_contenders())
    if (const MeasuredRow* row = find(rows, model, contender);
        finished(row) && row->value.status == SolveStatus::Converged)
      energies.push_back({row->value.energy, contender});
  if (energies.size() < 2) return;
  const auto by_energy = [](const auto& a, const auto& b) { return a.first < b.first; };
  const auto [low, high] = std::minmax_element(energies.begin(), energies.end(), by_energy);
  const double apart = (high->first - low->first) / std::max(low->first, 1e-300);
  std::printf("%-13s energies from %.6g (%s) to %.6g (%s): %s\n", model.c_str(), low->first,
              label(low->second), high->first, label(high->second),
              apart <= kAgree ? "within 1 %" : "they end in different states");
  if (const MeasuredRow* tangent = find(rows, model, Contender::Tangent); finished(tangent))
    std::printf("%-13s tangent's is %.2f %% above the lowest energy (<= 1 %%): %s\n", "",
                100.0 * (tangent->value.energy / std::max(low->first, 1e-300) - 1.0),
                met(tangent->value.energy <= (1.0 + kAgree) * low->first));
}

struct Sized {
  std::string model;
  double panels, seconds;
};

double slope(const Sized& a, const Sized& b) {
  return std::log(b.seconds / a.seconds) / std::log(b.panels / a.panels);
}

// Least squares in log-log.
double slope(const std::vector<Sized>& sizes) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Sized& size : sizes) {
    const double lx = std::log(size.panels), ly = std::log(size.seconds);
    n += 1.0;
    x += lx;
    y += ly;
    xx += lx * lx;
    xy += lx * ly;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void print_exponents(const Comparison& rows) {
  for (const Contender contender : all_contenders()) {
    std::vector<Sized> sizes;
    for (const char* model : {"torus-1k", "torus-10k", "torus-100k", kLargest})
      if (const MeasuredRow* row = find(rows, model, contender); finished(row))
        sizes.push_back({model, static_cast<double>(row->value.panels), row->value.cpu});
    if (sizes.size() < 2) continue;
    std::printf("%-14s CPU time grows as panels^%.2f by least squares", label(contender), slope(sizes));
    for (size_t k = 0; k + 1 < sizes.size(); ++k)
      std::printf("%s%s to %s: %.2f", k == 0 ? " (" : ", ", sizes[k].model.c_str(),
                  sizes[k + 1].model.c_str(), slope(sizes[k], sizes[k + 1]));
    std::printf(")\n");
  }
}

void print_memory(const Comparison& rows) {
  const MeasuredRow* row = find(rows, "torus-100k", Contender::Tangent);
  if (!finished(row)) return;
  std::printf("torus-100k    tangent's peak memory %.0f MB (<= %.0f MB): %s\n", row->usage.peak_mb,
              kMostMemoryMb, met(row->usage.peak_mb <= kMostMemoryMb));
}

}  // namespace

void print_goals(const Comparison& rows) {
  std::printf("\n");
  print_ratio(rows, "torus-10k", Contender::Default, 100.0);
  print_ratio(rows, "torus-10k", Contender::Tuned, 10.0);
  print_ratio(rows, "fertility", Contender::Default, 15.0);
  for (const char* model : {"torus-1k", "torus-10k", "torus-100k"}) print_energies(rows, model);
  print_exponents(rows);
  print_memory(rows);
}

}  // namespace planewright::bench
