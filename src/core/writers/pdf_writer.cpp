// format_pdf(), with cairo.
#include <cairo-pdf.h>

#include <cmath>
#include <memory>

#include "core/writers/clean_text.h"
#include "core/writers/drawing_writers.h"
#include "core/writers/pdf_sheet.h"
#include "core/writers/pdf_title.h"

namespace planewright {
namespace {

constexpr double kPoints = 72.0 / 25.4;  // of a millimetre
constexpr double kSmallestPage = 148.0;  // mm, the shorter side: A5

cairo_status_t append_bytes(void* out, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

Result<void> check(const std::vector<Drawing>& drawings, const PdfOptions& options) {
  const double width = options.page_width, height = options.page_height;
  if (!std::isfinite(width) || !std::isfinite(height) || std::min(width, height) < kSmallestPage)
    return fail(ErrorCode::Refused, "a page smaller than 148 mm leaves no room beside its title block",
                "PDF page", "Choose A5 or larger");
  for (const Drawing& drawing : drawings)
    if (auto checked = check_drawing(drawing); !checked) return checked;
  return {};
}

void set_metadata(cairo_surface_t* surface, const TitleBlock& title, const std::string& project) {
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, project.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_AUTHOR, clean_text(title.drawn_by).c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, clean_text(title.note).c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "Planewright");
}

}  // namespace

Result<std::string> format_pdf(const WorkshopModel& model, const std::vector<Drawing>& drawings,
                               const std::vector<std::string>& notes, const PdfOptions& options) {
  if (auto checked = check(drawings, options); !checked) return tl::unexpected(checked.error());
  const PageLayout layout = page_layout(options);
  const std::string project = clean_text(options.title.project.empty() ? model.title : options.title.project);

  std::string bytes;
  const std::unique_ptr<cairo_surface_t, Destroy> surface(cairo_pdf_surface_create_for_stream(
      append_bytes, &bytes, layout.width * kPoints, layout.height * kPoints));
  set_metadata(surface.get(), options.title, project);
  const std::unique_ptr<cairo_t, Destroy> context(cairo_create(surface.get()));
  cairo_scale(context.get(), kPoints, kPoints);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_MITER);
  PdfPen pen(context.get());

  // The pages of sheets come after those of the index, whose count does not depend on their numbers.
  std::vector<PlacedDrawing> placed;
  std::vector<IndexRow> rows;
  for (const Drawing& drawing : drawings) {
    placed.push_back(place_drawing(drawing, layout));
    rows.push_back(index_row(drawing, 0, placed.back().scale));
  }
  const int index_pages = IndexPages(pen, layout, rows, notes).count();
  for (size_t k = 0; k < rows.size(); ++k) rows[k].page = index_pages + static_cast<int>(k) + 1;
  const IndexPages index(pen, layout, rows, notes);
  const PanelNames panel_names(model.names.begin(), model.names.end());
  const int pages = index_pages + static_cast<int>(drawings.size());

  const auto finish_page = [&](const std::string& title, double scale, int page, bool without_edge_names) {
    draw_page_frame(pen, layout, options.title, project, {title, scale, page, pages, without_edge_names});
    const std::string link = "page=" + std::to_string(page);
    cairo_pdf_surface_add_outline(surface.get(), CAIRO_PDF_OUTLINE_ROOT, clean_text(title).c_str(),
                                  link.c_str(), CAIRO_PDF_OUTLINE_FLAG_OPEN);
    cairo_show_page(context.get());
  };
  for (int k = 0; k < index_pages; ++k) {
    index.draw(k);
    finish_page("Index", 0.0, k + 1, false);
  }
  for (size_t k = 0; k < drawings.size(); ++k) {
    draw_sheet(pen, panel_names, drawings[k], placed[k]);
    finish_page(drawings[k].title, placed[k].scale, index_pages + static_cast<int>(k) + 1,
                leaves_out_edge_names(panel_names, drawings[k], placed[k]));
  }
  cairo_surface_finish(surface.get());
  for (const cairo_status_t status : {cairo_status(context.get()), cairo_surface_status(surface.get())})
    if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
      return fail(ErrorCode::Refused, cairo_status_to_string(status), "PDF",
                  "Write the drawings as DXF or SVG");
  return bytes;
}

}  // namespace planewright
