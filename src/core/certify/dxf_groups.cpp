#include "core/certify/dxf_groups.h"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace planewright {
namespace {

using Eigen::Vector2d;

struct Group {
  int code = 0;
  std::string_view value;
  int line = 0;  // of the value
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

template <class T>
std::optional<T> parsed(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size()) return {};
  return value;
}

// "\U+00E4" as UTF-8. Four hexadecimal digits, as DXF has it.
std::string decoded(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text.substr(i, 3) == "\\U+" && i + 7 <= text.size() &&
        std::from_chars(text.data() + i + 3, text.data() + i + 7, code, 16).ptr == text.data() + i + 7) {
      if (code < 0x80) {
        out += static_cast<char>(code);
      } else if (code < 0x800) {
        out += static_cast<char>(0xC0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3F));
      } else {
        out += static_cast<char>(0xE0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (code & 0x3F));
      }
      i += 6;
    } else {
      out += text[i];
    }
  }
  return out;
}

// $INSUNITS of AutoCAD, those that are lengths a workshop uses.
std::optional<double> millimetres_per_insunit(int code) {
  switch (code) {
    case 1:
      return 25.4;
    case 2:
      return 304.8;
    case 4:
      return 1.0;
    case 5:
      return 10.0;
    case 6:
      return 1000.0;
    case 14:
      return 100.0;
    default:
      return {};
  }
}

// One entity or table entry: the groups from its 0 to the next.
struct Record {
  std::string_view type;
  int line = 0;
  std::vector<Group> groups;

  std::string text(int code) const {
    for (const Group& g : groups)
      if (g.code == code) return std::string(g.value);
    return {};
  }
};

class Reader {
 public:
  Reader(std::string_view content, const std::string& name) : content_(content), name_(name) {}

  Result<ReadDrawing> read() {
    std::string_view section;
    while (true) {
      auto record = next();
      if (!record) return tl::unexpected(record.error());
      const Record& r = *record;
      if (r.type == "EOF") break;
      Result<void> done;
      if (r.type == "SECTION") {
        const std::string_view title = first(r, 2);
        if (title.empty()) return error("a SECTION without name", r.line);
        section = title;
        if (section == "HEADER") done = header(r);
        if (section == "ENTITIES") has_entities_ = true;
      } else if (r.type == "ENDSEC") {
        section = {};
      } else if (section == "TABLES" && r.type == "LAYER") {
        drawing_.layers.emplace_back(first(r, 2));
      } else if (section == "ENTITIES") {
        done = entity(r);
      } else if (section.empty()) {
        return error("'" + std::string(r.type) + "' outside of every section", r.line);
      }
      if (!done) return tl::unexpected(done.error());
    }
    if (polyline_) return error("a POLYLINE without SEQEND", line_);
    if (!has_entities_) return error("no section ENTITIES", line_);
    scale();
    return std::move(drawing_);
  }

 private:
  tl::unexpected<Error> error(std::string what, int line) const {
    return fail(ErrorCode::Unreadable, std::move(what), name_ + ":" + std::to_string(line));
  }

  std::optional<std::string_view> next_line() {
    if (at_ >= content_.size()) return {};
    const size_t end = std::min(content_.find('\n', at_), content_.size());
    std::string_view line = content_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  Result<Group> next_group() {
    const auto code_line = next_line();
    if (!code_line) return error("the file ends without EOF", line_);
    const auto code = parsed<int>(*code_line);
    if (!code) return error("'" + std::string(code_line->substr(0, 20)) + "' is no group code", line_);
    const auto value = next_line();
    if (!value) return error("the file ends inside a group", line_);
    return Group{*code, *value, line_};
  }

  Result<Record> next() {
    if (!ahead_) {
      auto group = next_group();
      while (group && group->code == 999) group = next_group();  // comments
      if (!group) return tl::unexpected(group.error());
      if (group->code != 0) return error("a DXF file begins with group 0", group->line);
      ahead_ = *group;
    }
    Record record{trimmed(ahead_->value), ahead_->line, {}};
    ahead_.reset();
    if (record.type == "EOF") return record;
    while (true) {
      auto group = next_group();
      if (!group) return tl::unexpected(group.error());
      if (group->code == 0) {
        ahead_ = *group;
        return record;
      }
      if (group->code != 999) record.groups.push_back(*group);
    }
  }

  static std::string_view first(const Record& r, int code) {
    for (const Group& g : r.groups)
      if (g.code == code) return trimmed(g.value);
    return {};
  }
  Result<double> number(const Group& g) const {
    const auto value = parsed<double>(g.value);
    if (!value || !std::isfinite(*value))
      return error("'" + std::string(g.value.substr(0, 40)) + "' is no number", g.line);
    return *value;
  }
  Result<std::optional<double>> number(const Record& r, int code) const {
    for (const Group& g : r.groups)
      if (g.code == code) {
        const auto value = number(g);
        if (!value) return tl::unexpected(value.error());
        return std::optional<double>(*value);
      }
    return std::optional<double>();
  }
  // The point of codes `x` and `x` + 10; absent if the record has none.
  Result<std::optional<Vector2d>> point(const Record& r, int x) const {
    const auto px = number(r, x), py = number(r, x + 10);
    if (!px) return tl::unexpected(px.error());
    if (!py) return tl::unexpected(py.error());
    if (!*px || !*py) return std::optional<Vector2d>();
    return std::optional<Vector2d>(Vector2d(**px, **py));
  }
  Result<int> integer(const Record& r, int code) const {
    const std::string_view text = first(r, code);
    if (text.empty()) return 0;
    const auto value = parsed<int>(text);
    if (!value) return error("'" + std::string(text) + "' is no integer", r.line);
    return *value;
  }

  Result<void> header(const Record& r) {
    std::string_view variable;
    std::map<std::string_view, Vector2d> points;
    for (const Group& g : r.groups) {
      if (g.code == 9) {
        variable = trimmed(g.value);
      } else if (variable == "$INSUNITS" && g.code == 70) {
        const auto code = parsed<int>(g.value);
        if (!code) return error("$INSUNITS is no integer", g.line);
        drawing_.unit = "$INSUNITS " + std::to_string(*code);
        drawing_.mm_per_unit = millimetres_per_insunit(*code);
      } else if ((variable == "$EXTMIN" || variable == "$EXTMAX") && (g.code == 10 || g.code == 20)) {
        const auto value = number(g);
        if (!value) return tl::unexpected(value.error());
        points.try_emplace(variable, Vector2d::Zero()).first->second[g.code / 10 - 1] = *value;
      }
    }
    if (points.contains("$EXTMIN") && points.contains("$EXTMAX"))
      drawing_.size = points["$EXTMAX"] - points["$EXTMIN"];
    return {};
  }

  Result<void> entity(const Record& r) {
    if (r.type == "POLYLINE") return begin_polyline(r);
    if (r.type == "VERTEX") return vertex(r);
    if (r.type == "SEQEND") return end_polyline(r);
    if (polyline_) return error("a POLYLINE without SEQEND", r.line);
    if (r.type == "LWPOLYLINE") return lightweight(r);
    if (r.type == "LINE") return line(r);
    if (r.type == "TEXT") return text(r);
    return error("an entity '" + std::string(r.type) + "', which no drawing for cutting has", r.line);
  }

  Result<void> begin_polyline(const Record& r) {
    if (polyline_) return error("a POLYLINE inside another", r.line);
    const auto flags = integer(r, 70);
    if (!flags) return tl::unexpected(flags.error());
    if (*flags & ~(1 | 8 | 128)) return error("a POLYLINE that is a curve or a mesh", r.line);
    polyline_ = ReadLine{r.text(8), {}, {}, (*flags & 1) != 0};
    points_.clear();
    return {};
  }
  Result<void> vertex(const Record& r) {
    if (!polyline_) return error("a VERTEX outside of a POLYLINE", r.line);
    const auto p = point(r, 10);
    if (!p) return tl::unexpected(p.error());
    if (!*p) return error("a VERTEX without point", r.line);
    const auto bulge = number(r, 42);
    if (!bulge) return tl::unexpected(bulge.error());
    if (bulge->value_or(0.0) != 0.0) return error("a POLYLINE with an arc", r.line);
    points_.push_back(**p);
    return {};
  }
  Result<void> end_polyline(const Record& r) {
    if (!polyline_) return error("a SEQEND without POLYLINE", r.line);
    add(std::move(*polyline_));
    polyline_.reset();
    return {};
  }
  Result<void> lightweight(const Record& r) {
    points_.clear();
    const auto flags = integer(r, 70), count = integer(r, 90);
    if (!flags) return tl::unexpected(flags.error());
    if (!count) return tl::unexpected(count.error());
    double x = 0.0;
    bool has_x = false;
    for (const Group& g : r.groups) {
      if (g.code != 10 && g.code != 20 && g.code != 42) continue;
      const auto value = number(g);
      if (!value) return tl::unexpected(value.error());
      if (g.code == 42) {
        if (*value != 0.0) return error("an LWPOLYLINE with an arc", g.line);
      } else if (g.code == 10) {
        if (has_x) return error("a point without y", g.line);
        x = *value;
        has_x = true;
      } else {
        if (!has_x) return error("a point without x", g.line);
        points_.emplace_back(x, *value);
        has_x = false;
      }
    }
    if (has_x) return error("a point without y", r.line);
    if (*count != static_cast<int>(points_.size()))
      return error("an LWPOLYLINE of " + std::to_string(points_.size()) + " points that says it has " +
                       std::to_string(*count),
                   r.line);
    add({r.text(8), {}, {}, (*flags & 1) != 0});
    return {};
  }
  Result<void> line(const Record& r) {
    const auto from = point(r, 10), to = point(r, 11);
    if (!from) return tl::unexpected(from.error());
    if (!to) return tl::unexpected(to.error());
    if (!*from || !*to) return error("a LINE without its two points", r.line);
    points_ = {**from, **to};
    add({r.text(8), {}, {}, false});
    return {};
  }
  Result<void> text(const Record& r) {
    const auto insertion = point(r, 10), aligned = point(r, 11);
    if (!insertion) return tl::unexpected(insertion.error());
    if (!aligned) return tl::unexpected(aligned.error());
    if (!*insertion) return error("a TEXT without place", r.line);
    const auto across = integer(r, 72), along = integer(r, 73);
    if (!across) return tl::unexpected(across.error());
    if (!along) return tl::unexpected(along.error());
    // Texts that are aligned otherwise than at the left of the baseline stand at their second point.
    const bool second = (*across != 0 || *along != 0) && aligned->has_value();
    drawing_.texts.push_back({r.text(8), {}, decoded(r.text(1)), second ? **aligned : **insertion});
    return {};
  }

  void add(ReadLine read) {
    if (read.closed && points_.size() > 1 && points_.front() == points_.back()) points_.pop_back();
    read.points.resize(static_cast<Eigen::Index>(points_.size()), 2);
    for (size_t i = 0; i < points_.size(); ++i) read.points.row(static_cast<Eigen::Index>(i)) = points_[i];
    drawing_.lines.push_back(std::move(read));
  }

  void scale() {
    const double mm = drawing_.mm_per_unit.value_or(1.0);
    for (ReadLine& l : drawing_.lines) l.points *= mm;
    for (ReadText& t : drawing_.texts) t.at *= mm;
    if (drawing_.size) *drawing_.size *= mm;
  }

  std::string_view content_;
  const std::string& name_;
  size_t at_ = 0;
  int line_ = 0;
  std::optional<Group> ahead_;
  std::optional<ReadLine> polyline_;
  std::vector<Vector2d> points_;
  bool has_entities_ = false;
  ReadDrawing drawing_;
};

}  // namespace

Result<ReadDrawing> read_dxf_groups(std::string_view content, const std::string& name) {
  return Reader(content, name).read();
}

}  // namespace planewright
