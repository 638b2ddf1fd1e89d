// What a PDF has to show of the drawings. Internal to certify/. Threads: pure.
#pragma once

#include <vector>

#include "core/certify/certificate.h"
#include "core/certify/pdf_reader.h"

namespace planewright {

// The first page is the index, then a page per drawing. Coordinates of PDFs are multiples of 1/256 point, so
// contours agree to that times the scale, not to 1e-6 mm.
std::vector<Check> check_pdf(const std::vector<ReadPage>& pages, const ExportContent& content);

}  // namespace planewright
