// What a document knows of the workshop, as a project file has it, both ways. Internal to edit/. Threads:
// pure.
#pragma once

#include "core/edit/json_reader.h"
#include "core/workshop/contract.h"

namespace planewright {

nlohmann::ordered_json contract_json(const WorkshopContract& contract);

// What is absent is as WorkshopContract begins. Fails for negative thicknesses, gaps and densities, and as
// read_tolerance_sheet() does.
WorkshopContract read_contract(JsonReading& reading, const nlohmann::json* json, const std::string& path);

}  // namespace planewright
