#include "ui/export_choice.h"

#include <ctime>

namespace planewright::ui {

bool lacks_thickness(ExportFormat format, const WorkshopContract& contract) {
  return format == ExportFormat::ThreeMf && contract.thickness <= 0.0;
}

ExportSettings export_settings(const ExportChoice& choice, const WorkshopContract& contract,
                               const std::string& title, const std::string& date, bool overwrite) {
  ExportSettings settings;
  for (const ExportFormat format : choice.formats)
    if (!lacks_thickness(format, contract)) settings.formats.insert(format);
  settings.tolerances = contract.tolerances;
  settings.on_failure = choice.on_failure;
  settings.thickness = contract.thickness;
  settings.gap = contract.gap;
  settings.density = contract.density;
  const ExportLayout& layout = choice.layout;
  if (layout.sheets)
    settings.nesting = NestingOptions{layout.sheet, layout.spacing, layout.margin, layout.rotate};
  settings.labels = {layout.text_height, layout.edge_names, layout.engrave_names};
  settings.dxf = choice.dxf;
  const PageMeasure& page = kPages[static_cast<std::size_t>(choice.page)];
  settings.pdf.landscape = !layout.sheets || layout.sheet.width >= layout.sheet.height;
  settings.pdf.page_width = settings.pdf.landscape ? page.longer : page.shorter;
  settings.pdf.page_height = settings.pdf.landscape ? page.shorter : page.longer;
  settings.pdf.title = {choice.project.empty() ? title : choice.project, choice.drawn_by, date, choice.note};
  settings.overwrite = overwrite;
  return settings;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  char text[16];
  if (localtime_r(&now, &parts) == nullptr || std::strftime(text, sizeof text, "%Y-%m-%d", &parts) == 0)
    return {};
  return text;
}

}  // namespace planewright::ui
