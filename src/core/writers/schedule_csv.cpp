#include <cmath>

#include "core/writers/clean_text.h"
#include "core/writers/number_text.h"
#include "core/writers/schedule_parts.h"
#include "core/writers/schedule_writers.h"

namespace planewright {
namespace {

// One line of a table; RFC 4180.
class Row {
 public:
  explicit Row(std::string& out) : out_(out) {}
  ~Row() { out_ += "\r\n"; }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  Row& text(const std::string& value) {
    begin();
    const std::string clean = clean_text(value);
    if (clean.find_first_of(",\"") == std::string::npos) {
      out_ += clean;
      return *this;
    }
    out_ += '"';
    for (const char c : clean) out_.append(c == '"' ? 2 : 1, c);
    out_ += '"';
    return *this;
  }
  Row& integer(int value) {
    begin();
    append_number(out_, value);
    return *this;
  }
  // Empty where there is no finite number.
  Row& number(double value) {
    begin();
    if (std::isfinite(value)) append_number(out_, value);
    return *this;
  }
  Row& number(const std::optional<double>& value) { return value ? number(*value) : empty(); }
  Row& empty() {
    begin();
    return *this;
  }

 private:
  void begin() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  std::string& out_;
  bool first_ = true;
};

}  // namespace

std::string format_panel_csv(const ScheduleSources& sources) {
  const ScheduleIndex index(sources);
  std::string out =
      "name,number,class,mirrored,corners,area_m2,perimeter_mm,width_mm,height_mm,planarity_mm,distance_mm,"
      "weight_kg,sheet,verdict,failures\r\n";
  for (const PanelPassport& passport : *sources.passports) {
    const int p = passport.panel;
    const WorkshopModel& model = *sources.model;
    Row row(out);
    row.text(model.names.at(p)).integer(model.numbers.at(p));
    if (index.class_of(p) >= 0)
      row.integer(index.class_of(p) + 1).text(index.mirrored(p) ? "yes" : "no");
    else
      row.empty().empty();
    row.integer(model.panels.valence(p))
        .number(passport.area * kSquareMetres)
        .number(passport.perimeter)
        .number(passport.width)
        .number(passport.height)
        .number(passport.planarity)
        .number(passport.distance)
        .number(passport.weight);
    if (index.sheet_of(p) >= 0)
      row.integer(index.sheet_of(p) + 1);
    else
      row.empty();
    row.text(index.verdict(p)).text(index.failures_text(p));
  }
  return out;
}

std::string format_edge_csv(const ScheduleSources& sources) {
  const WorkshopModel& model = *sources.model;
  std::string out = "panel,side,neighbour,length_mm,interior_deg,dihedral_deg,bevel_deg\r\n";
  for (const PanelPassport& passport : *sources.passports) {
    for (size_t k = 0; k < passport.sides.size(); ++k) {
      const SidePassport& side = passport.sides[k];
      Row(out)
          .text(model.names.at(passport.panel))
          .integer(static_cast<int>(k) + 1)
          .text(side.neighbour >= 0 ? model.names.at(side.neighbour) : "")
          .number(side.length)
          .number(side.interior)
          .number(side.dihedral)
          .number(side.bevel);
    }
  }
  return out;
}

}  // namespace planewright
