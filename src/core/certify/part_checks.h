// The parts on the drawings, proved of the drawings themselves: whatever laid them. Internal to certify/.
// Threads: pure.
#pragma once

#include <vector>

#include "core/certify/certificate.h"

namespace planewright {

// "every part on one drawing": each panel that has a pattern and is not left out, and no other; "parts as
// their patterns": turned and moved, nothing else; "parts apart": none overlap or are nearer than the spacing
// (in rows: none overlap); "parts inside the margins" of their sheet (in rows: on the page).
std::vector<Check> check_parts(const ExportContent& content);

}  // namespace planewright
