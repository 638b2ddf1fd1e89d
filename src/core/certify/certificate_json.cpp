#include <nlohmann/json.hpp>

#include "core/base/version.h"
#include "core/certify/certificate.h"

namespace planewright {
namespace {

using Json = nlohmann::ordered_json;

Json checks_json(const std::vector<Check>& checks) {
  Json list = Json::array();
  for (const Check& c : checks) list.push_back({{"name", c.name}, {"pass", c.pass}, {"detail", c.detail}});
  return list;
}

}  // namespace

std::string to_json(const Certificate& certificate, const ExportContent& content) {
  Json files = Json::array(), left_out = Json::array();
  for (const FileCertificate& f : certificate.files)
    files.push_back(
        {{"file", f.file}, {"reader", f.reader}, {"pass", f.pass()}, {"checks", checks_json(f.checks)}});
  for (const int p : content.left_out) left_out.push_back(content.model->names[static_cast<size_t>(p)]);
  const Json json{{"format", "planewright certificate"},
                  {"tool", "Planewright"},
                  {"version", kVersion},
                  {"title", content.model->title},
                  {"unit", "mm"},
                  {"pass", certificate.pass()},
                  {"panels", content.model->panel_count()},
                  {"panels_within_tolerances", content.verdicts->passed},
                  {"panels_beyond_tolerances", content.verdicts->failed},
                  {"left_out", left_out},
                  {"design", checks_json(certificate.design)},
                  {"files", files}};
  // What a broken file said may be any bytes.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planewright
