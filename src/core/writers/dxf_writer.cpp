#include <cmath>
#include <numbers>

#include "core/writers/drawing_writers.h"
#include "core/writers/dxf_groups.h"
#include "core/writers/dxf_tables.h"
#include "core/writers/file_layers.h"

namespace planewright {
namespace {

void begin_entity(DxfGroups& out, const char* type, std::string_view layer) {
  out.record(type, kModelSpaceRecord);
  out.subclass("AcDbEntity");
  out.text(8, layer);
}

void light_polyline(DxfGroups& out, const DrawingLine& line, std::string_view layer) {
  begin_entity(out, "LWPOLYLINE", layer);
  out.subclass("AcDbPolyline");
  out.integer(90, static_cast<int>(line.points.rows()));
  out.integer(70, line.closed ? 1 : 0);
  for (Eigen::Index i = 0; i < line.points.rows(); ++i) out.point(10, line.points(i, 0), line.points(i, 1));
}

// Of R12.
void heavy_polyline(DxfGroups& out, const DrawingLine& line, std::string_view layer) {
  begin_entity(out, "POLYLINE", layer);
  out.integer(66, 1);
  out.point(10, 0.0, 0.0, 0.0);
  out.integer(70, line.closed ? 1 : 0);
  for (Eigen::Index i = 0; i < line.points.rows(); ++i) {
    out.text(0, "VERTEX");
    out.text(8, layer);
    out.point(10, line.points(i, 0), line.points(i, 1), 0.0);
  }
  out.text(0, "SEQEND");
  out.text(8, layer);
}

void text_entity(DxfGroups& out, const DrawingText& text, std::string_view layer) {
  const std::string written = dxf_text(text.text);
  begin_entity(out, "TEXT", layer);
  out.subclass("AcDbText");
  // Where the text begins. Programs work it out from the middle below with their font; it counts only for
  // those that know no middle: a character is about 0.9 heights wide.
  const double half_width = 0.45 * text.height * static_cast<double>(written.size());
  const double c = std::cos(text.rotation), s = std::sin(text.rotation);
  const double half_height = text.height / 2.0;
  out.point(10, text.at.x() - c * half_width + s * half_height,
            text.at.y() - s * half_width - c * half_height, 0.0);
  out.real(40, text.height);
  out.text(1, written);
  out.real(50, text.rotation * 180.0 / std::numbers::pi);
  out.text(7, out.handles() ? "Standard" : "STANDARD");
  out.integer(72, 1);  // centred
  out.point(11, text.at.x(), text.at.y(), 0.0);
  out.subclass("AcDbText");
  out.integer(73, 2);  // on its middle line
}

void write_entities(DxfGroups& out, const Drawing& drawing) {
  out.begin_section("ENTITIES");
  for (const DrawingLine& line : drawing.lines) {
    const std::string_view layer = kFileLayers[file_layer(line)].name;
    if (out.handles())
      light_polyline(out, line, layer);
    else
      heavy_polyline(out, line, layer);
  }
  for (const DrawingText& text : drawing.texts) text_entity(out, text, kFileLayers[file_layer(text)].name);
  out.end_section();
}

}  // namespace

std::string format_dxf(const Drawing& drawing, DxfVersion version) {
  const DxfExtent extent = dxf_extent(drawing);
  // The header names the first free handle, so it is written last.
  DxfGroups body(version == DxfVersion::R2000);
  write_dxf_tables(body, extent);
  write_dxf_blocks(body);
  write_entities(body, drawing);
  write_dxf_objects(body);
  body.text(0, "EOF");

  DxfGroups file(version == DxfVersion::R2000);
  write_dxf_header(file, extent, body.take_handle());
  file.append(body);
  return file.take();
}

}  // namespace planewright
