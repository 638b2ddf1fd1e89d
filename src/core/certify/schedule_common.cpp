#include "core/certify/schedule_common.h"

#include "core/certify/check_text.h"

namespace planewright {

std::string name_of_panel(const ExportContent& content, int panel) {
  return panel >= 0 ? content.model->names[static_cast<size_t>(panel)] : std::string();
}

std::map<std::string, const PanelPassport*> passports_by_name(const ExportContent& content) {
  std::map<std::string, const PanelPassport*> all;
  for (const PanelPassport& p : *content.passports) all[name_of_panel(content, p.panel)] = &p;
  return all;
}

Check row_count(size_t rows, size_t wanted, const char* of) {
  return {"number of rows", rows == wanted,
          counted(static_cast<long long>(rows)) + " rows for " + counted(static_cast<long long>(wanted)) +
              " " + of};
}

Check names_once(const std::vector<std::string>& names, const ExportContent& content) {
  std::map<std::string, int> seen;
  for (const std::string& n : names) ++seen[n];
  std::vector<std::string> wrong;
  int right = 0;
  for (const std::string& n : content.model->names) {
    const auto found = seen.find(n);
    if (found != seen.end() && found->second == 1)
      ++right;
    else
      wrong.push_back(n + (found == seen.end() ? " is missing" : " more than once"));
    if (found != seen.end()) seen.erase(found);
  }
  for (const auto& [n, times] : seen) wrong.push_back("'" + n + "' is no panel");
  std::string detail = counted(right) + " of " + counted(content.model->panel_count()) + " names";
  if (!wrong.empty()) detail += "; " + listed(wrong);
  return {"every name once", wrong.empty(), detail};
}

}  // namespace planewright
