#include "ui/schedule_filter.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/workshop/nearest_word.h"
#include "core/workshop/panel_names.h"
#include "ui/format.h"
#include "ui/script.h"

namespace planewright::ui {
namespace {

using Term = ScheduleTerm;
using Op = ScheduleTerm::Op;

// What can be compared with a number. A null `value`: any edge of the panel.
struct Measure {
  std::string_view word;
  std::string_view unit;
  double (*value)(const ScheduleRow&);
};
constexpr std::array<Measure, 12> kMeasures = {{
    {"corners", "", [](const ScheduleRow& row) { return static_cast<double>(row.corners); }},
    {"area", "m²", [](const ScheduleRow& row) { return row.area; }},
    {"edge", "mm", nullptr},
    {"shortest", "mm", [](const ScheduleRow& row) { return row.edge_min; }},
    {"longest", "mm", [](const ScheduleRow& row) { return row.edge_max; }},
    {"angle", "°", [](const ScheduleRow& row) { return row.interior_min; }},
    {"bevel", "°", [](const ScheduleRow& row) { return row.bevel_max; }},
    {"planarity", "mm", [](const ScheduleRow& row) { return row.planarity; }},
    {"distance", "mm", [](const ScheduleRow& row) { return row.distance; }},
    {"weight", "kg", [](const ScheduleRow& row) { return row.weight; }},
    {"width", "mm", [](const ScheduleRow& row) { return row.width; }},
    {"height", "mm", [](const ScheduleRow& row) { return row.height; }},
}};

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string lowered(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), lower);
  return out;
}

bool same_word(std::string_view name, std::string_view lower_word) {
  return name.size() == lower_word.size() && std::equal(name.begin(), name.end(), lower_word.begin(),
                                                        [](char a, char b) { return lower(a) == b; });
}

bool contains_word(std::string_view name, std::string_view lower_word) {
  return std::search(name.begin(), name.end(), lower_word.begin(), lower_word.end(),
                     [](char a, char b) { return lower(a) == b; }) != name.end();
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
bool is_operator(char c) {
  return c == '<' || c == '>' || c == '=' || c == '!' || c == ':';
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

bool is_unit(std::string_view word) {
  return word == "m2" || std::any_of(kMeasures.begin(), kMeasures.end(), [&](const Measure& measure) {
           return !measure.unit.empty() && word == measure.unit;
         });
}

// Words with no blanks inside: those round operators go. "area > 2  C" -> "area>2", "C"
std::vector<std::string> words_of(std::string_view given) {
  std::string text(given);
  replace_all(text, "≤", "<=");
  replace_all(text, "≥", ">=");
  replace_all(text, "≠", "!=");
  std::vector<std::string> words;
  bool apart = true;  // a blank stands before
  for (const char c : text) {
    if (is_blank(c)) {
      apart = true;
      continue;
    }
    const bool joins = !words.empty() && (is_operator(c) || is_operator(words.back().back()));
    if (words.empty() || (apart && !joins)) words.emplace_back();
    words.back() += c;
    apart = false;
  }
  // A unit belongs to the number before it.
  for (std::size_t i = words.size(); i-- > 1;) {
    const bool compares = std::any_of(words[i - 1].begin(), words[i - 1].end(), is_operator);
    if (!compares || !is_unit(lowered(words[i]))) continue;
    words[i - 1] += words[i];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return words;
}

// "'edgy<3': columns are ..."
std::string not_understood(const std::string& word, const std::string& why) {
  return "'" + word + "': " + why;
}

std::string measures_text(const std::string& meant) {
  std::vector<std::string> words;
  for (const Measure& measure : kMeasures) words.emplace_back(measure.word);
  std::string text = "columns are ";
  for (const std::string& word : words) text += word + ", ";
  text += "class, to";
  const std::string nearest = nearest_word(meant, words);
  const bool near = !meant.empty() && !nearest.empty() && lower(meant[0]) == nearest[0];
  return near ? text + ". Is " + nearest + " meant?" : text;
}

// The number, perhaps with the unit of the measure behind it.
std::optional<double> number_with_unit(std::string text, std::string_view unit) {
  for (const std::string_view ending : {unit, unit == "m²" ? std::string_view("m2") : unit}) {
    if (!ending.empty() && text.ends_with(ending)) {
      text.erase(text.size() - ending.size());
      break;
    }
  }
  const auto number = number_in(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::string> why_unknown(std::string_view measure, const Schedule& schedule) {
  if (measure == "distance" && !schedule.distances) return "distances are known when a solve has ended";
  if (measure == "weight" && !schedule.weights) return "weights are known with a thickness and a density";
  return std::nullopt;
}

class Parser {
 public:
  explicit Parser(const Schedule& schedule) : schedule_(schedule) {}

  void word(const std::string& word) {
    const auto op_at = std::find_if(word.begin(), word.end(), is_operator);
    if (op_at == word.end()) return plain(word);
    const std::string subject = lowered(std::string_view(word.begin(), op_at));
    auto value_at = op_at;
    while (value_at != word.end() && is_operator(*value_at)) ++value_at;
    const std::string op(op_at, value_at), value(value_at, word.end());
    if (subject == "to" || subject == "class") {
      if (op != ":" && op != "=") return reject(word, "it takes a colon, as in " + subject + ":A");
      return subject == "to" ? beside(word, lowered(value)) : of_class(word, lowered(value));
    }
    const auto measure =
        std::find_if(kMeasures.begin(), kMeasures.end(), [&](const Measure& m) { return m.word == subject; });
    if (measure == kMeasures.end()) return reject(word, measures_text(subject));
    compare(word, static_cast<std::size_t>(measure - kMeasures.begin()), op, value);
  }

  ScheduleFilter filter;

 private:
  void reject(const std::string& word, const std::string& why) {
    if (filter.error.empty()) filter.error = not_understood(word, why);
  }
  void plain(const std::string& word) {
    Term term;
    term.word = lowered(word);
    if (term.word == "fails" || term.word == "passes")
      term.kind = term.word == "fails" ? Term::Kind::Fails : Term::Kind::Passes;
    filter.terms.push_back(term);
  }
  void beside(const std::string& word, const std::string& name) {
    if (name.empty()) return reject(word, "a panel's name comes after the colon");
    Term term;
    term.kind = Term::Kind::Beside;
    term.word = name;
    bool part = false;
    for (int panel = 0; panel < schedule_.size() && !term.whole; ++panel) {
      term.whole = same_word(schedule_.name(panel), name);
      part = part || contains_word(schedule_.name(panel), name);
    }
    if (!term.whole && !part) return reject(word, "no panel has such a name");
    filter.terms.push_back(term);
  }
  void of_class(const std::string& word, const std::string& label) {
    if (!schedule_.classes) return reject(word, "classes are known when a solve has ended");
    const auto count = static_cast<int>(schedule_.from->classes.size());
    if (label.empty()) return reject(word, "a class comes after the colon, as in class:12");
    Term term;
    term.kind = Term::Kind::Class;
    for (int c = 0; c < count && term.class_index < 0; ++c)
      if (class_label(c) == label) term.class_index = c;
    if (term.class_index < 0)
      return reject(word, count == 1 ? "the only class is 1" : "classes are 1 to " + class_label(count - 1));
    filter.terms.push_back(term);
  }
  void compare(const std::string& word, std::size_t measure, const std::string& op,
               const std::string& value) {
    static constexpr std::array<std::pair<std::string_view, Op>, 8> kOps = {{{"<", Op::Less},
                                                                             {"<=", Op::LessEqual},
                                                                             {">", Op::Greater},
                                                                             {">=", Op::GreaterEqual},
                                                                             {"=", Op::Equal},
                                                                             {"==", Op::Equal},
                                                                             {":", Op::Equal},
                                                                             {"!=", Op::Unequal}}};
    const auto known = std::find_if(kOps.begin(), kOps.end(), [&](const auto& o) { return o.first == op; });
    if (known == kOps.end()) return reject(word, "comparisons are <, <=, >, >=, = and !=");
    const Measure& of = kMeasures[measure];
    const auto number = number_with_unit(lowered(value), of.unit);
    if (!number) {
      const std::string unit(of.unit);
      return reject(word, "a number comes after " + op + (unit.empty() ? "" : ", in " + unit));
    }
    if (const auto why = why_unknown(of.word, schedule_)) return reject(word, *why);
    Term term;
    term.kind = Term::Kind::Compare;
    term.measure = measure;
    term.op = known->second;
    term.value = *number;
    filter.terms.push_back(term);
  }

  const Schedule& schedule_;
};

bool holds(double value, Op op, double wanted, const std::string& wanted_text) {
  if (std::isnan(value)) return false;
  const auto reads_the_same = [&] { return value == wanted || format_number(value) == wanted_text; };
  switch (op) {
    case Op::Less:
      return value < wanted;
    case Op::LessEqual:
      return value <= wanted || reads_the_same();
    case Op::Greater:
      return value > wanted;
    case Op::GreaterEqual:
      return value >= wanted || reads_the_same();
    case Op::Equal:
      return reads_the_same();
    case Op::Unequal:
      break;
  }
  return !reads_the_same();
}

bool compares(const Term& term, const Schedule& schedule, int panel) {
  const bool by_text = term.op != Op::Less && term.op != Op::Greater;
  const std::string text = by_text ? format_number(term.value) : std::string();
  const Measure& measure = kMeasures[term.measure];
  if (measure.value != nullptr) return holds(measure.value(schedule.row(panel)), term.op, term.value, text);
  const auto& sides = schedule.from->passports[static_cast<std::size_t>(panel)].sides;
  const auto side_holds = [&](const SidePassport& side) {
    return holds(side.length, term.op, term.value, text);
  };
  // No edge is to have that length, where a length is ruled out.
  return term.op == Op::Unequal ? std::all_of(sides.begin(), sides.end(), side_holds)
                                : std::any_of(sides.begin(), sides.end(), side_holds);
}

bool is_beside(const Term& term, const Schedule& schedule, int panel) {
  const auto& sides = schedule.from->passports[static_cast<std::size_t>(panel)].sides;
  return std::any_of(sides.begin(), sides.end(), [&](const SidePassport& side) {
    if (side.neighbour < 0) return false;
    const std::string& name = schedule.name(side.neighbour);
    return term.whole ? same_word(name, term.word) : contains_word(name, term.word);
  });
}

bool matches(const Term& term, const Schedule& schedule, int panel) {
  switch (term.kind) {
    case Term::Kind::Name:
      return contains_word(schedule.name(panel), term.word);
    case Term::Kind::Beside:
      return is_beside(term, schedule, panel);
    case Term::Kind::Fails:
      return schedule.row(panel).failure >= 0;
    case Term::Kind::Passes:
      return schedule.row(panel).failure < 0;
    case Term::Kind::Class:
      return schedule.row(panel).class_index == term.class_index;
    case Term::Kind::Compare:
      break;
  }
  return compares(term, schedule, panel);
}

}  // namespace

ScheduleFilter parse_schedule_filter(std::string_view text, const Schedule& schedule) {
  Parser parser(schedule);
  for (const std::string& word : words_of(text)) parser.word(word);
  return std::move(parser.filter);
}

bool matches(const ScheduleFilter& filter, const Schedule& schedule, int panel) {
  return std::all_of(filter.terms.begin(), filter.terms.end(),
                     [&](const ScheduleTerm& term) { return matches(term, schedule, panel); });
}

}  // namespace planewright::ui
