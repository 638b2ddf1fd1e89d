#include "core/certify/pdf_text_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/certify/border_distance.h"
#include "core/certify/check_text.h"
#include "core/certify/edge_name_checks.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

// Capitals as the reader measures them are known to some per cent of the font.
constexpr double kFont = 0.95;

}  // namespace

PdfTextChecks::PdfTextChecks(const ExportContent& content)
    : content_(content), panel_names_(content.model->names.begin(), content.model->names.end()) {}

void PdfTextChecks::page(const ReadPage& page, const Drawing& drawing, double scale, const Vector2d& shift,
                         double slack, const std::string& where) {
  EdgeNames names(drawing, content_, kLeastPdfText * scale, slack * scale);
  std::map<int, const Contour*> cut;
  for (const DrawingLine& l : drawing.lines)
    if (l.layer == DrawingLayer::Cut && l.closed && l.panel >= 0) cut.try_emplace(l.panel, &l.points);
  const std::string there = " (" + where + ")";
  std::map<std::string, int> texts;
  bool said = false;
  for (const ReadText& t : page.texts) {
    ++texts[t.text];
    said = said || t.text.find(kPdfEdgeNamesLeftOut) != std::string::npos;
    if (!panel_names_.contains(t.text)) continue;
    const Vector2d at = t.at * scale - shift;
    // The title block and the scale bar may say what a panel is called, too.
    if (at.x() < 0.0 || at.y() < 0.0 || at.x() > drawing.width || at.y() > drawing.height) continue;
    const int panel = names.panel_at(at);
    if (panel >= 0 && content_.model->names[static_cast<size_t>(panel)] == t.text) {
      const double box = 0.5 * std::hypot(t.width / std::max(t.height, 1e-9), 1.0) * kLeastPdfName;
      if (t.height < kFont * kLeastPdfName && box / kFont <= to_border(*cut.at(panel), at) / scale)
        sizes_.push_back(t.text + there);
    } else {
      names.found(t.text, at);
      if (t.height < kFont * kLeastPdfText) sizes_.push_back("edge name " + t.text + there);
    }
  }
  for (const std::string& wrong : names.wrong()) edges_.push_back(wrong + there);
  for (const std::string& note : names.notes())
    if (texts[note]-- <= 0) edges_.push_back("'" + note + "' is missing" + there);
  if (said != (names.left_out() > 0))
    edges_.push_back(said ? "said to be left out" + there : "left out unsaid" + there);
  edge_names_ += names.wanted();
  left_out_ += names.left_out();
}

void PdfTextChecks::append_to(std::vector<Check>& checks, bool whole) const {
  std::string edges = counted(edge_names_) + " names, each nearest to the side of its neighbour";
  if (left_out_ > 0)
    edges +=
        "; " + counted(left_out_) + " below " + brief(kLeastPdfText) + " mm left out, which their pages say";
  checks.push_back(
      {"edge names", whole && edges_.empty(), edges_.empty() ? edges : "wrong: " + listed(edges_)});
  checks.push_back({"legible names", whole && sizes_.empty(),
                    sizes_.empty() ? "of panels at least " + brief(kLeastPdfName) +
                                         " mm where their part has room, of edges " + brief(kLeastPdfText)
                                   : "too small: " + listed(sizes_)});
}

}  // namespace planewright
