// What a person is told of a diagnosis.
#pragma once

#include <string>

#include "core/export/diagnosis_record.h"

namespace planewright::cli {

// Prints how the layer was solved and a table of what was found, the worst of each kind first and not more
// than 20 of a kind.
void print_findings(const DiagnosisRecord& record, const std::string& input);

}  // namespace planewright::cli
