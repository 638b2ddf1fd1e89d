// Contenders: who is measured against whom, by the names of --only.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common_stop.h"
#include "core/complex/tangent_complex.h"
#include "measurement.h"
#include "models.h"

namespace planewright::bench {

enum class Contender {
  Default,  // Ipopt's default options in raw coordinates (baselines.h)
  Tuned,    // Ipopt with the first prototype's options, in mean edges (baselines.h)
  Ipopt,    // the shipped general solver, and so on
  Tangent,
  Auto,
};

const std::vector<Contender>& all_contenders();
const char* name(Contender contender);   // "default", "tuned", ...: the keys of --only
const char* label(Contender contender);  // "Ipopt default", ...

// Throws std::runtime_error, the known names listed.
Contender find_contender(const std::string& name);

// Solves for planar panels near the design (position energy alone) until `test` is met. Baselines are asked
// by CommonStop at each iterate; the shipped solvers have their own test of the same quantity, and always end
// on all planes to rounding. Throws std::runtime_error.
Measurement solve(Contender contender, std::shared_ptr<const TangentComplex> complex, const StopTest& test);

// The same in a process of its own, which loads the model first: the best of `repeats`.
MeasuredRow measure(Contender contender, const Model& model, const std::filesystem::path& meshes,
                    const StopTest& test, int repeats, const ChildLimits& limits);

}  // namespace planewright::bench
