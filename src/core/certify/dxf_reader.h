// DXF by two readers that have to agree: dime says what there is (entities, layers, texts, numbers of points,
// coordinates in the single precision that it keeps them in, up to 2.5e-4 mm off at 6 m), our own reader of
// group codes gives the coordinates in double. Internal to certify/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/certify/read_drawing.h"

namespace planewright {

struct ReadDxf {
  ReadDrawing drawing;
  std::vector<std::string> disagreements;  // between the two readers
};

std::string dxf_reader_name();
Result<ReadDxf> read_dxf(const std::filesystem::path& path);

}  // namespace planewright
