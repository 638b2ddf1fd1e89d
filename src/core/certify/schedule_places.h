// Where a JSON schedule lays parts on sheets. Internal to certify/. Threads: pure.
#pragma once

#include "core/certify/certificate.h"
#include "core/certify/json_fields.h"

namespace planewright {

// "places on sheets": sizes, fillings, what fits no sheet, and of each part the motion that lays its pattern
// where the drawing shows it; in rows: none.
Check check_places(const Json& json, const ExportContent& content);

}  // namespace planewright
