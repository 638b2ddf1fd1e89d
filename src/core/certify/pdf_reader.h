// PDF by qpdf: boxes of pages, and of their content streams the paths and the texts, in mm on the page.
// Internal to certify/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/certify/read_drawing.h"

namespace planewright {

struct ReadPage {
  double width = 0.0, height = 0.0;  // mm, of the media box
  // Straight pieces of paths that are painted; layer and panel empty. y up, (0, 0) the lower left corner.
  std::vector<ReadLine> lines;
  std::vector<ReadText> texts;  // by the fonts' ToUnicode maps, else as Latin-1; `at` is the middle
};

std::string pdf_reader_name();

// Fails with ErrorCode::Unreadable: qpdf would have to repair it, a content stream with an unknown operand.
Result<std::vector<ReadPage>> read_pdf(const std::filesystem::path& path);

}  // namespace planewright
