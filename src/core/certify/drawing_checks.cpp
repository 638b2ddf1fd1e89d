#include "core/certify/drawing_checks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/certify/check_text.h"
#include "core/certify/contour_match.h"
#include "core/certify/edge_name_checks.h"
#include "core/certify/exact_signs.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

constexpr double kLimit = 1e-6;  // mm

// The layers of the files, as drawing_writers.h lists them.
std::string file_layer(DrawingLayer layer) {
  switch (layer) {
    case DrawingLayer::Cut:
      return "CUT";
    case DrawingLayer::Engrave:
      return "ENGRAVE";
    case DrawingLayer::Text:
      return "TEXT";
    case DrawingLayer::Sheet:
      return "SHEET";
  }
  return {};
}

bool is_name(const ReadText& text) {
  return text.layer == "TEXT" && (text.panel.empty() || text.panel == text.text);
}

// Lines of one layer, wanted and read, closed ones and open ones apart.
struct Lines {
  std::vector<const DrawingLine*> wanted;
  std::vector<const ReadLine*> read;
  std::vector<ContourMatch> matches;  // #wanted
};
Lines lines_of(const ReadDrawing& read, const Drawing& drawing, DrawingLayer layer, bool closed) {
  Lines lines;
  std::vector<const Contour*> wanted, found;
  for (const DrawingLine& l : drawing.lines)
    if (l.layer == layer && l.closed == closed) {
      lines.wanted.push_back(&l);
      wanted.push_back(&l.points);
    }
  for (const ReadLine& l : read.lines)
    if (l.layer == file_layer(layer) && l.closed == closed) {
      lines.read.push_back(&l);
      found.push_back(&l.points);
    }
  lines.matches = match_contours(wanted, found, closed, kLimit);
  return lines;
}

double perimeter(const Contour& c, bool closed) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i + (closed ? 0 : 1) < c.rows(); ++i)
    sum += (c.row((i + 1) % c.rows()) - c.row(i)).norm();
  return sum;
}

// How long the file's lines are against the drawing's: the median over all, so that one wrong line is no
// wrong scale.
Check scale(const ReadDrawing& read, const Lines& cut) {
  if (!read.mm_per_unit) return {"scale", false, "the file does not say its unit (" + read.unit + ")"};
  std::vector<double> ratios;
  for (size_t i = 0; i < cut.wanted.size(); ++i)
    if (cut.matches[i].read >= 0)
      ratios.push_back(perimeter(cut.read[static_cast<size_t>(cut.matches[i].read)]->points, true) /
                       perimeter(cut.wanted[i]->points, true));
  if (ratios.empty()) return {"scale", cut.wanted.empty(), "nothing to measure; " + read.unit};
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return {"scale", std::abs(*middle - 1.0) <= 1e-9,
          read.unit + "; a millimetre of the model is " +
              (*middle == 1.0 ? "1" : "1 + (" + brief(*middle - 1.0) + ")") + " mm in the file"};
}

Check size(const ReadDrawing& read, const Drawing& drawing) {
  if (!read.size) return {"size", false, "the file declares none"};
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const DrawingLine& l : drawing.lines) {
    low = low.cwiseMin(l.points.colwise().minCoeff().transpose());
    high = high.cwiseMax(l.points.colwise().maxCoeff().transpose());
  }
  // A DXF file may declare the sheet or what is drawn on it.
  const double sheet = (*read.size - Vector2d(drawing.width, drawing.height)).cwiseAbs().maxCoeff();
  const double drawn = drawing.lines.empty() ? sheet : (*read.size - (high - low)).cwiseAbs().maxCoeff();
  const double difference = std::min(sheet, drawn);
  return {"size", difference <= kLimit, against_limit(difference, kLimit, "mm")};
}

Check lines_equal(std::string name, const Lines& closed, const Lines& open, const WorkshopModel& model) {
  double largest = 0.0;
  size_t right = 0;
  std::vector<std::string> wrong;
  for (const Lines* lines : {&closed, &open})
    for (size_t i = 0; i < lines->wanted.size(); ++i) {
      const ContourMatch& match = lines->matches[i];
      if (match.read >= 0 && match.difference <= kLimit)
        ++right;
      else
        wrong.push_back(lines->wanted[i]->panel >= 0
                            ? model.names[static_cast<size_t>(lines->wanted[i]->panel)]
                            : std::string("a line of no panel"));
      if (match.read >= 0) largest = std::max(largest, match.difference);
    }
  const size_t wanted = closed.wanted.size() + open.wanted.size(),
               read = closed.read.size() + open.read.size();
  std::string detail = counted(static_cast<long long>(right)) + " of " +
                       counted(static_cast<long long>(wanted)) + ", " + against_limit(largest, kLimit, "mm");
  if (read != wanted) detail += "; the file has " + counted(static_cast<long long>(read));
  if (!wrong.empty()) detail += "; wrong: " + listed(wrong);
  return {std::move(name), right == wanted && read == wanted, detail};
}

// Signs decided exactly, of what the file says.
void shape_checks(const Lines& cut, const WorkshopModel& model, std::vector<Check>& checks) {
  std::vector<std::string> crossing, turned;
  const auto name = [&](size_t i) {
    const int panel = cut.wanted[i]->panel;
    return panel >= 0 ? model.names[static_cast<size_t>(panel)] : std::string("a contour of no panel");
  };
  for (size_t i = 0; i < cut.wanted.size(); ++i) {
    if (cut.matches[i].read < 0) continue;  // the contours' check says so
    const Contour& read = cut.read[static_cast<size_t>(cut.matches[i].read)]->points;
    if (!is_simple(read)) crossing.push_back(name(i));
    if (area_sign(read) != area_sign(cut.wanted[i]->points)) turned.push_back(name(i));
  }
  const std::string all = counted(static_cast<long long>(cut.wanted.size())) + " contours, exact";
  checks.push_back(
      {"simple contours", crossing.empty(), crossing.empty() ? all : "crossing: " + listed(crossing)});
  checks.push_back({"orientation", turned.empty(), turned.empty() ? all : "reversed: " + listed(turned)});
}

Check layers(const ReadDrawing& read, const Drawing& drawing) {
  static const std::set<std::string> known{"CUT", "ENGRAVE", "TEXT", "TEXT_EDGES", "SHEET"};
  const std::set<std::string> declared(read.layers.begin(), read.layers.end());
  std::set<std::string> needed, wrong;
  for (const DrawingLine& l : drawing.lines) needed.insert(file_layer(l.layer));
  for (const DrawingText& t : drawing.texts) needed.insert(t.is_name ? "TEXT" : file_layer(t.layer));
  for (const std::string& layer : needed)
    if (!declared.contains(layer)) wrong.insert(layer + " is missing");
  const auto used = [&](const std::string& layer) {
    if (!known.contains(layer))
      wrong.insert("'" + layer + "' is no layer of ours");
    else if (!declared.contains(layer))
      wrong.insert(layer + " is not declared");
  };
  for (const ReadLine& l : read.lines) used(l.layer);
  for (const ReadText& t : read.texts) used(t.layer);
  const std::vector<std::string> list(wrong.begin(), wrong.end());
  const std::vector<std::string> fine(needed.begin(), needed.end());
  return {"layers", wrong.empty(), wrong.empty() ? listed(fine) : listed(list)};
}

void name_checks(const ReadDrawing& read, const Drawing& drawing, const WorkshopModel& model,
                 std::vector<Check>& checks) {
  const std::vector<int> panels = panels_cut(drawing);
  const ShownParts shown = shown_parts(read);
  std::vector<std::string> missing, twice, unknown, astray;
  std::map<std::string, int> panel_of;
  for (const int p : panels) {
    const std::string& name = model.names[static_cast<size_t>(p)];
    panel_of[name] = p;
    const auto found = shown.names.find(name);
    if (found == shown.names.end())
      missing.push_back(name);
    else if (found->second != 1)
      twice.push_back(name);
  }
  for (const auto& [name, times] : shown.names)
    if (!panel_of.contains(name)) unknown.push_back(name);
  const bool pass = missing.empty() && twice.empty() && unknown.empty();
  std::string detail = counted(static_cast<long long>(panels.size() - missing.size() - twice.size())) +
                       " of " + counted(static_cast<long long>(panels.size())) + " names once";
  if (!missing.empty()) detail += "; missing: " + listed(missing);
  if (!twice.empty()) detail += "; more than once: " + listed(twice);
  if (!unknown.empty()) detail += "; of no panel here: " + listed(unknown);
  checks.push_back({"every name once", pass, detail});

  std::map<int, const Contour*> outline;
  for (const DrawingLine& l : drawing.lines)
    if (l.layer == DrawingLayer::Cut && l.closed && l.panel >= 0) outline.try_emplace(l.panel, &l.points);
  for (const ReadText& t : read.texts) {
    const auto known = panel_of.find(t.text);
    if (is_name(t) && known != panel_of.end() && !covers(*outline.at(known->second), t.at))
      astray.push_back(t.text);
  }
  checks.push_back({"names on their parts", astray.empty(),
                    astray.empty() ? "inside their contours, exact" : "outside: " + listed(astray)});
}

}  // namespace

std::vector<int> panels_cut(const Drawing& drawing) {
  std::set<int> panels;
  for (const DrawingLine& l : drawing.lines)
    if (l.layer == DrawingLayer::Cut && l.closed && l.panel >= 0) panels.insert(l.panel);
  return {panels.begin(), panels.end()};
}

ShownParts shown_parts(const ReadDrawing& read) {
  ShownParts shown;
  for (const ReadText& t : read.texts)
    if (is_name(t)) ++shown.names[t.text];
  for (const ReadLine& l : read.lines)
    if (l.layer == "CUT" && l.closed) ++shown.contours;
  return shown;
}

std::vector<Check> check_drawing(const ReadDrawing& read, const ExportContent& content,
                                 const Drawing& drawing) {
  std::vector<Check> checks;
  const WorkshopModel& model = *content.model;
  const auto both = [&](DrawingLayer layer) {
    return std::pair(lines_of(read, drawing, layer, true), lines_of(read, drawing, layer, false));
  };
  const auto cut = both(DrawingLayer::Cut), engraved = both(DrawingLayer::Engrave),
             sheet = both(DrawingLayer::Sheet);
  checks.push_back(scale(read, cut.first));
  checks.push_back(size(read, drawing));
  checks.push_back(layers(read, drawing));
  checks.push_back(lines_equal("contours", cut.first, cut.second, model));
  checks.push_back(lines_equal("engraving", engraved.first, engraved.second, model));
  checks.push_back(lines_equal("sheet border", sheet.first, sheet.second, model));
  shape_checks(cut.first, model, checks);
  name_checks(read, drawing, model, checks);
  checks.push_back(check_edge_names(read, drawing, content));
  return checks;
}

std::vector<Check> check_all_parts(const std::vector<ShownParts>& files, const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  const std::set<int> left_out(content.left_out.begin(), content.left_out.end());
  std::map<std::string, int> seen;
  int contours = 0;
  for (const ShownParts& file : files) {
    for (const auto& [name, times] : file.names) seen[name] += times;
    contours += file.contours;
  }
  std::vector<std::string> wrong;
  int parts = 0, right = 0;
  for (int p = 0; p < model.panel_count(); ++p) {
    const bool has_pattern = !content.patterns || !(*content.patterns)[static_cast<size_t>(p)].empty();
    const int wanted = has_pattern && !left_out.contains(p) ? 1 : 0;
    const std::string& name = model.names[static_cast<size_t>(p)];
    const auto found = seen.find(name);
    const int times = found == seen.end() ? 0 : found->second;
    parts += wanted;
    if (times == wanted)
      right += wanted;
    else
      wrong.push_back(name + " " + std::to_string(times) + " times");
  }
  std::string names = counted(right) + " of " + counted(parts) + " names";
  if (!wrong.empty()) names += "; " + listed(wrong);
  std::string cut = counted(contours) + " contours to cut for " + counted(parts) + " parts";
  if (!content.left_out.empty()) cut += ", " + counted(static_cast<long long>(left_out.size())) + " left out";
  return {{"every name once", wrong.empty(), names}, {"number of parts", contours == parts, cut}};
}

}  // namespace planewright
