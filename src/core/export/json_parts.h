// What the JSON reports of this folder have in common. Internal to export/. Threads: pure.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/complex/tangent_complex.h"
#include "core/diagnose/diagnosis.h"
#include "core/mesh/health_report.h"
#include "core/problem/element.h"

namespace planewright {

using Json = nlohmann::ordered_json;

// The keys that every report begins with.
Json heading(const std::string& input);
const char* key(ComplexKind kind);
Json element_json(const ElementRef& element);
Json health_json(const HealthReport& health);
// How many findings of each kind, by its name; null of a state that was not solved.
Json counts_json(const Diagnosis& diagnosis);
// The text of a report. A file's name may be any bytes; those that are not UTF-8 are replaced.
std::string written(const Json& json);

}  // namespace planewright
