#include "core/certify/pdf_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "core/certify/check_text.h"
#include "core/certify/contour_match.h"
#include "core/certify/drawing_checks.h"
#include "core/certify/exact_signs.h"
#include "core/certify/pdf_text_checks.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

// On paper: coordinates are rounded to 1/256 point, written with a few digits, both ends of a line.
constexpr double kPaper = 1.5 * 25.4 / 72.0 / 256.0;  // mm

// The n of a text "1:n" (or of one that ends so, "Scale 1:20").
std::optional<double> written_scale(const std::string& text) {
  const size_t at = text.rfind("1:");
  if (at == std::string::npos || (at > 0 && text[at - 1] != ' ')) return {};
  double n = 0.0;
  const char* begin = text.data() + at + 2;
  while (*begin == ' ') ++begin;
  const char* stop = text.data() + text.size();
  const auto end = std::from_chars(begin, stop, n);
  if (end.ec != std::errc() || end.ptr != stop || !(n > 0.0)) return {};
  return n;
}

Vector2d lower_left(const Contour& c) {
  return c.colwise().minCoeff();
}

// The drawing's place on its page: page = drawing / scale + shift.
struct Place {
  Vector2d shift;
  size_t found = 0;       // contours that lie where they should
  double largest = 0.0;   // mm of the drawing
  std::vector<int> lost;  // panels
};

class PageMatch {
 public:
  PageMatch(const ReadPage& page, const Drawing& drawing, double scale)
      : scale_(scale), limit_(kPaper * scale) {
    for (const DrawingLine& l : drawing.lines)
      if (l.layer == DrawingLayer::Cut && l.closed) wanted_.push_back(&l);
    for (const ReadLine& l : page.lines) {
      if (!l.closed || l.points.rows() < 3) continue;
      read_.push_back(l.points * scale);
      corners_.emplace_back(lower_left(read_.back()), read_.size() - 1);
    }
    std::sort(corners_.begin(), corners_.end(),
              [](const auto& a, const auto& b) { return a.first.x() < b.first.x(); });
  }

  size_t wanted() const { return wanted_.size(); }
  double limit() const { return limit_; }

  // Every path that has the shape of the first contours says where the drawing may lie.
  Place best() const {
    Place best;
    for (size_t first = 0; first < std::min<size_t>(wanted_.size(), 3) && best.found == 0; ++first) {
      const Vector2d corner = lower_left(wanted_[first]->points);
      for (const auto& [at, j] : corners_) {
        const Vector2d shift = at - corner;
        if (border_distance(wanted_[first]->points.rowwise() + shift.transpose(), read_[j]) > limit_)
          continue;
        // How many lie right says which one it is; most often the first that fits.
        Place place = laid(shift);
        if (place.found > best.found || best.found == 0) best = std::move(place);
        if (best.found == wanted_.size()) return best;
      }
    }
    if (best.found == 0)
      for (const DrawingLine* l : wanted_) best.lost.push_back(l->panel);
    return best;
  }

 private:
  Place laid(const Vector2d& shift) const {
    Place place{shift, 0, 0.0, {}};
    std::vector<bool> used(read_.size(), false);
    for (const DrawingLine* line : wanted_) {
      const Contour moved = line->points.rowwise() + shift.transpose();
      const Vector2d corner = lower_left(moved);
      const auto begin = std::lower_bound(corners_.begin(), corners_.end(), corner.x() - 2.0 * limit_,
                                          [](const auto& c, double x) { return c.first.x() < x; });
      // The nearest one: contours that are engraved may lie nearer to those that are cut than paper is exact.
      size_t nearest = read_.size();
      double distance = 2.0 * limit_;  // the shift itself is rounded, too
      for (auto at = begin; at != corners_.end() && at->first.x() <= corner.x() + 2.0 * limit_; ++at) {
        if (used[at->second] || std::abs(at->first.y() - corner.y()) > 2.0 * limit_) continue;
        const double far = border_distance(moved, read_[at->second]);
        if (far > distance) continue;
        nearest = at->second;
        distance = far;
      }
      if (nearest < read_.size()) {
        used[nearest] = true;
        place.largest = std::max(place.largest, distance);
        ++place.found;
      } else {
        place.lost.push_back(line->panel);
      }
    }
    return place;
  }

  double scale_, limit_;
  std::vector<const DrawingLine*> wanted_;
  std::vector<Contour> read_;  // mm of the drawing
  std::vector<std::pair<Vector2d, size_t>> corners_;
};

// Names whose text does not begin inside their contour exactly once.
std::vector<std::string> names_astray(const ReadPage& page, const Drawing& drawing,
                                      const WorkshopModel& model, double scale, const Vector2d& shift) {
  std::multimap<std::string, Vector2d> texts;
  for (const ReadText& t : page.texts) texts.emplace(t.text, t.at * scale - shift);
  std::vector<std::string> astray;
  for (const DrawingLine& l : drawing.lines) {
    if (l.layer != DrawingLayer::Cut || !l.closed || l.panel < 0) continue;
    const std::string& name = model.names[static_cast<size_t>(l.panel)];
    int inside = 0;
    const auto [begin, end] = texts.equal_range(name);
    for (auto at = begin; at != end; ++at) inside += covers(l.points, at->second) ? 1 : 0;
    if (inside != 1) astray.push_back(name);
  }
  return astray;
}

Check page_sizes(const std::vector<ReadPage>& pages, const PdfOptions& options) {
  const auto [low, high] = std::minmax(options.page_width, options.page_height);
  const double width = options.landscape ? high : low, height = options.landscape ? low : high;
  double largest = 0.0;
  for (const ReadPage& page : pages)
    largest = std::max({largest, std::abs(page.width - width), std::abs(page.height - height)});
  constexpr double kLimit = 0.01;
  return {"page size", largest <= kLimit, against_limit(largest, kLimit, "mm")};
}

}  // namespace

std::vector<Check> check_pdf(const std::vector<ReadPage>& pages, const ExportContent& content) {
  // One page per drawing, after an index of as many pages as its lines need.
  const size_t drawn = content.drawings.size();
  const bool enough = pages.size() > drawn;
  const size_t index = enough ? pages.size() - drawn : 1;
  std::vector<Check> checks{{"number of pages", enough,
                             counted(static_cast<long long>(pages.size())) + ", the last " +
                                 counted(static_cast<long long>(drawn)) + " drawings"},
                            page_sizes(pages, content.pdf)};
  std::vector<std::string> no_scale, lost, astray;
  size_t contours = 0, found = 0;
  double largest = 0.0, limit = 0.0, coarsest = 0.0;
  PdfTextChecks texts(content);
  for (size_t d = 0; d < content.drawings.size() && d + index < pages.size(); ++d) {
    const ReadPage& page = pages[d + index];
    const Drawing& drawing = content.drawings[d];
    const std::string where = "page " + std::to_string(d + index + 1);
    // The scale that is written has to be the one that is drawn.
    std::optional<Place> best;
    double scale = 0.0;
    for (const ReadText& t : page.texts) {
      const auto n = written_scale(t.text);
      if (!n || *n == scale) continue;
      const PageMatch match(page, drawing, *n);
      Place place = match.best();
      if (best && place.found <= best->found) continue;
      best = std::move(place);
      scale = *n;
      limit = std::max(limit, 2.0 * match.limit());
    }
    contours += panels_cut(drawing).size();
    if (!best || (best->found == 0 && !panels_cut(drawing).empty())) {
      no_scale.push_back(where);
      continue;
    }
    coarsest = std::max(coarsest, scale);
    found += best->found;
    largest = std::max(largest, best->largest);
    for (const int p : best->lost)
      lost.push_back((p >= 0 ? content.model->names[static_cast<size_t>(p)] : std::string("a contour")) +
                     " (" + where + ")");
    for (const std::string& name : names_astray(page, drawing, *content.model, scale, best->shift))
      astray.push_back(name + " (" + where + ")");
    texts.page(page, drawing, scale, best->shift, 3.0 * kPaper, where);
  }
  const bool any = enough;
  checks.push_back({"scale", any && no_scale.empty(),
                    no_scale.empty() ? "as written on each page, 1:" + brief(coarsest) + " at the coarsest"
                                     : "no scale is written that the drawing has: " + listed(no_scale)});
  std::string shapes = counted(static_cast<long long>(found)) + " of " +
                       counted(static_cast<long long>(contours)) + ", " +
                       against_limit(largest, limit, "mm") + ": PDF rounds on paper";
  if (!lost.empty()) shapes += "; lost: " + listed(lost);
  checks.push_back({"contours", any && found == contours, shapes});
  checks.push_back({"names on their parts", any && no_scale.empty() && astray.empty(),
                    astray.empty() ? "each once inside its contour" : "not once inside: " + listed(astray)});
  texts.append_to(checks, any && no_scale.empty());
  return checks;
}

}  // namespace planewright
