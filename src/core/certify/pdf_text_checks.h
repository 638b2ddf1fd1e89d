// What the pages of a PDF say of their parts besides each one's name, and how legibly. Internal to certify/.
// Threads: pure.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "core/certify/certificate.h"
#include "core/certify/pdf_reader.h"

namespace planewright {

class PdfTextChecks {
 public:
  explicit PdfTextChecks(const ExportContent& content);

  // page = drawing / scale + shift / scale. slack: mm on paper, by how much another side may be nearer to a
  // name than its own. where: "page 3".
  void page(const ReadPage& page, const Drawing& drawing, double scale, const Eigen::Vector2d& shift,
            double slack, const std::string& where);

  // "edge names": there from kLeastPdfText upwards, each nearest to the side of its neighbour; none below,
  // and then the page says so; notes are there. "legible names": none of edges below that, and those of
  // panels not below kLeastPdfName where their part has room for it. whole: every page was looked at.
  void append_to(std::vector<Check>& checks, bool whole) const;

 private:
  const ExportContent& content_;
  std::unordered_set<std::string> panel_names_;
  std::vector<std::string> edges_, sizes_;  // what is wrong
  long long edge_names_ = 0, left_out_ = 0;
};

}  // namespace planewright
