// Units of length of a document and of what leaves it. Inside, workshop, pattern, writers and certify know
// millimetres alone; this is where model units become millimetres and back.
//
// Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace planewright {

enum class LengthUnit { Millimetre, Centimetre, Metre, Inch, Foot };

// All of them, in the order that a menu shows.
const std::vector<LengthUnit>& length_units();

// Exact by definition: 1, 10, 1000, 25.4, 304.8.
double millimetres_per(LengthUnit unit);

// "mm", "cm", "m", "in", "ft"
std::string_view symbol(LengthUnit unit);

// The unit of a symbol or name ("mm", "inch", "metre", any case). Fails with ErrorCode::Usage, listing those
// that exist. `where`: what the error names as its place ("--unit").
Result<LengthUnit> parse_length_unit(std::string_view text, std::string where);

}  // namespace planewright
