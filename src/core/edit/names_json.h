// What elements and panels are called, as a project file has it, both ways. Internal to edit/. Threads: pure.
#pragma once

#include "core/edit/element_names.h"
#include "core/edit/given_names.h"
#include "core/edit/json_reader.h"

namespace planewright {

nlohmann::ordered_json names_json(const ElementNames& names);
nlohmann::ordered_json given_names_json(const GivenNames& given);

// Fails for numbers that are not those of a mesh like this: too few or many, given twice, never given.
ElementNames read_names(JsonReading& reading, const nlohmann::json& json, const std::string& path,
                        const PolygonMesh& mesh);
// Fails as check_names() does.
GivenNames read_given_names(JsonReading& reading, const nlohmann::json& json, const std::string& path);

}  // namespace planewright
