// planewright-bench: measures solvers side by side in one run.
//
//   compare         Ipopt default, Ipopt tuned, tangent and auto, all to one first-order residual, over tori
//                   of growing size and real meshes: hours, so see --only, --models and --limit
//   live            from a slider's move to the first planar panels
//   advice          how well predicted gains of edits rank them, and what rating them costs
//   cluster         what clustering a mesh costs, anew and while the number of regions is dragged
//   findings        what finding the bad places of solved panels costs, by detector
//   workshop        what an export in all formats costs, certificate included
//   warm-start      iterations of Ipopt alone, and from where the tangent solver ended
//
// Without one of those words each solver ends by its own termination:
//
//   (no options)                    the general solver and its frozen baselines, torus of 10,000 panels
//   --rows 40 --columns 40          a small one
//   --mesh FILE...                  the general solver alone on real meshes
//   --no-penetration                duals with the paper's constraints; with --solver ipopt,tangent,auto,
//                                   --offset E..., --also NAME..., --mesh FILE...
//   --uncrossed --mesh FILE...      quads that do not cross themselves; with --solver
//
// Each measurement is a process of its own, on one thread; ratios within one run are what counts on a shared
// machine.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "advice.h"
#include "blas_threads.h"
#include "cluster.h"
#include "compare.h"
#include "demands.h"
#include "findings.h"
#include "live.h"
#include "own_termination.h"
#include "warm_start.h"
#include "workshop.h"

int main(int argc, char** argv) {
  using namespace planewright;
  bench::restart_with_one_blas_thread(argv);
  CLI::App app{"Measures solvers side by side in one run"};
  int rows = 100, columns = 100;  // frozen: 10,000 panels
  bool only_ours = false, no_penetration = false, uncrossed = false;
  bench::DemandOptions demands;
  app.add_option("--rows", rows, "Torus: vertices round the tube")->check(CLI::Range(4, 2000));
  app.add_option("--columns", columns, "Torus: vertices round the axis")->check(CLI::Range(4, 2000));
  app.add_flag("--only-ours", only_ours, "Leave out the baselines");
  app.add_option("--mesh", demands.files, "Real meshes instead of the torus");
  auto* constraints = app.add_flag("--no-penetration", no_penetration, "Duals with the paper's constraints");
  app.add_option("--offset", demands.offsets, "With --no-penetration: offsets, mean panel edges")
      ->needs(constraints);
  app.add_option("--also", demands.also, "With --no-penetration: further demands, by name")
      ->needs(constraints);
  app.add_flag("--uncrossed", uncrossed, "Real meshes planarized with the preset 'uncrossed'");
  app.add_option("--solver", demands.solvers,
                 "With --no-penetration or --uncrossed: ipopt, tangent, auto, several with commas between")
      ->delimiter(',');
  app.add_option("--limit", demands.seconds,
                 "With --no-penetration or --uncrossed: cut a row off after so many seconds")
      ->check(CLI::PositiveNumber);
  app.require_subcommand(0, 1);
  bench::declare_advice(app);
  bench::declare_cluster(app);
  bench::declare_compare(app);
  bench::declare_findings(app);
  bench::declare_live(app);
  bench::declare_warm_start(app);
  bench::declare_workshop(app);
  try {
    app.parse(argc, argv);
    if (!app.get_subcommands().empty()) return 0;
    if (no_penetration)
      bench::measure_non_penetration(demands);
    else if (uncrossed)
      bench::measure_uncrossed(demands);
    else if (demands.files.empty())
      bench::compare_on_torus(rows, columns, !only_ours);
    else
      bench::measure_meshes(demands.files);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "planewright-bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
