#include "core/workshop/panel_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "core/workshop/panel_rows.h"

namespace planewright {
namespace {

std::string folded(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string panel_text(int number) {
  return "panel " + std::to_string(number);
}

// Names in use, and which of them belong to which panel number.
struct Kept {
  std::map<int, std::string> by_number;
  std::set<std::string> taken;  // folded
};

Result<Kept> check_kept(const std::vector<std::pair<int, std::string>>& kept) {
  Kept result;
  std::map<std::string, int> owners;
  for (const auto& [number, name] : kept) {
    if (name.empty()) return fail(ErrorCode::Refused, "the kept name is empty", panel_text(number));
    const auto odd = std::find_if(name.begin(), name.end(), [](char c) {
      return !is_letter(c) && !is_digit(c) && c != '-' && c != '_' && c != '.';
    });
    if (odd != name.end())
      return fail(ErrorCode::Refused,
                  "the kept name '" + name + "' has other characters than A-Z, a-z, 0-9, '-', '_' and '.'",
                  panel_text(number), "Rename the panel in the schedule that names are kept from");
    const auto [of_number, is_new] = result.by_number.emplace(number, name);
    if (!is_new && of_number->second != name)
      return fail(ErrorCode::Refused,
                  "there are two kept names, '" + of_number->second + "' and '" + name + "'",
                  panel_text(number));
    const auto [owner, is_free] = owners.emplace(folded(name), number);
    if (!is_free && owner->second != number)
      return fail(ErrorCode::Refused,
                  "the kept name '" + name + "' is that of panel " + std::to_string(owner->second) + ", too",
                  panel_text(number), "Rename one of them in the schedule that names are kept from");
    result.taken.insert(folded(name));
  }
  return result;
}

std::string padded(int number, size_t digits) {
  std::string text = std::to_string(number);
  return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

// Gives the panels of one series (a row; all panels) their names: number `wanted[i]` if that is free, else
// the next free one beyond `last`.
template <class Name>
void name_series(const std::vector<int>& panels, const std::vector<int>& wanted, int last, Name&& name_of,
                 const std::vector<int>& numbers, Kept& kept, std::vector<std::string>& names) {
  std::vector<int> late;
  for (size_t i = 0; i < panels.size(); ++i) {
    const auto panel = static_cast<size_t>(panels[i]);
    const auto own = kept.by_number.find(numbers[panel]);
    if (own != kept.by_number.end()) {
      names[panel] = own->second;
      continue;
    }
    const std::string name = name_of(wanted[i]);
    if (kept.taken.insert(folded(name)).second)
      names[panel] = name;
    else
      late.push_back(panels[i]);
  }
  int next = last;
  for (const int panel : late) {
    std::string name;
    do name = name_of(++next);
    while (!kept.taken.insert(folded(name)).second);
    names[static_cast<size_t>(panel)] = name;
  }
}

// One run of digits, or of letters, or one other character, off the front.
std::string_view take_run(std::string_view& rest) {
  size_t n = 1;
  if (is_digit(rest[0]))
    while (n < rest.size() && is_digit(rest[n])) ++n;
  else if (is_letter(rest[0]))
    while (n < rest.size() && is_letter(rest[n])) ++n;
  const std::string_view run = rest.substr(0, n);
  rest.remove_prefix(n);
  return run;
}

// Negative, 0 or positive. Digits before letters before the others.
int compare_runs(std::string_view a, std::string_view b) {
  const auto rank = [](char c) { return is_digit(c) ? 0 : is_letter(c) ? 1 : 2; };
  if (rank(a[0]) != rank(b[0])) return rank(a[0]) - rank(b[0]);
  if (rank(a[0]) == 0) {
    a.remove_prefix(std::min(a.find_first_not_of('0'), a.size()));
    b.remove_prefix(std::min(b.find_first_not_of('0'), b.size()));
  }
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  return folded(a).compare(folded(b));
}

}  // namespace

std::string row_letters(int row) {
  std::string letters;
  for (int left = row + 1; left > 0; left = (left - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
  return letters;
}

bool natural_name_less(std::string_view a, std::string_view b) {
  std::string_view left = a, right = b;
  while (!left.empty() && !right.empty()) {
    const int order = compare_runs(take_run(left), take_run(right));
    if (order != 0) return order < 0;
  }
  if (left.empty() != right.empty()) return left.empty();
  return a < b;
}

Result<std::vector<std::string>> name_panels(const Points& points, const Polygons& panels, const Vector3d& up,
                                             NameStyle style, const std::vector<int>& numbers,
                                             const std::vector<std::pair<int, std::string>>& kept_names) {
  auto kept = check_kept(kept_names);
  if (!kept) return tl::unexpected(std::move(kept.error()));
  std::vector<std::string> names(static_cast<size_t>(panels.size()));
  if (style == NameStyle::Plain) {
    std::vector<int> all, wanted;
    int last = 0;
    for (int p = 0; p < panels.size(); ++p) {
      all.push_back(p);
      wanted.push_back(numbers[static_cast<size_t>(p)] + 1);
      last = std::max(last, wanted.back());
    }
    name_series(
        all, wanted, last, [](int n) { return std::to_string(n); }, numbers, *kept, names);
    return names;
  }
  const std::vector<std::vector<int>> rows = panel_rows(points, panels, up);
  size_t longest = 0;
  for (const auto& row : rows) longest = std::max(longest, row.size());
  const size_t digits = std::to_string(longest).size();
  for (size_t r = 0; r < rows.size(); ++r) {
    std::vector<int> wanted;
    for (size_t i = 0; i < rows[r].size(); ++i) wanted.push_back(static_cast<int>(i) + 1);
    const std::string letters = row_letters(static_cast<int>(r));
    name_series(
        rows[r], wanted, static_cast<int>(wanted.size()),
        [&](int n) { return letters + "-" + padded(n, digits); }, numbers, *kept, names);
  }
  return names;
}

}  // namespace planewright
