// How much of what it may a panel makes use of: what colours of the tolerances are made from.
//
// Of an upper limit the measure as part of the limit, of a lower one the limit as part of the measure; 1 is
// the limit itself. The verdict has the last word: what passes is kept at kMostPassing or below, what fails
// at kLeastFailing or above, so that a colour map that breaks at 1 breaks between pass and fail and nowhere
// else, also in the single precision of a graphics card. Threads: pure.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/workshop/tolerance_sheet.h"

namespace planewright {

inline constexpr double kMostPassing = 0.999, kLeastFailing = 1.001;

// The kinds that a sheet sets a limit for, and CrossesItself, in the order of the enumeration.
std::vector<ToleranceKind> limited_kinds(const ToleranceSheet& sheet);

// #P; of one kind, or the largest of all. Not a number where nothing is measured (no limit of that kind). A
// share is not negative, and at most 1000. verdicts: of these passports and this sheet.
Vector tolerance_shares(const std::vector<PanelPassport>& passports, const ToleranceVerdicts& verdicts,
                        const ToleranceSheet& sheet, std::optional<ToleranceKind> kind = {});

}  // namespace planewright
