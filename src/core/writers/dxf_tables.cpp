#include "core/writers/dxf_tables.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/writers/file_layers.h"

namespace planewright {
namespace {

// Handles of the tables, the same as AutoCAD's own templates have.
constexpr std::uint32_t kBlockRecords = 0x1, kLayers = 0x2, kStyles = 0x3, kLineTypes = 0x5, kViews = 0x6,
                        kUcs = 0x7, kViewports = 0x8, kApplications = 0x9, kDimensionStyles = 0xA,
                        kRootDictionary = 0xC, kGroupDictionary = 0xD, kByBlock = 0x14, kByLayer = 0x15,
                        kContinuous = 0x16, kModelSpaceBegin = 0x20, kModelSpaceEnd = 0x21,
                        kPaperSpaceBegin = 0x1C, kPaperSpaceEnd = 0x1D, kStandardStyle = 0x11;

void begin_table(DxfGroups& out, const char* name, std::uint32_t handle, int entries) {
  out.text(0, "TABLE");
  out.text(2, name);
  if (out.handles()) {
    out.handle(5, handle);
    out.handle(330, 0);
    out.subclass("AcDbSymbolTable");
  }
  out.integer(70, entries);
}

void end_table(DxfGroups& out) {
  out.text(0, "ENDTAB");
}

void begin_entry(DxfGroups& out, const char* type, std::uint32_t table, const char* subclass) {
  out.record(type, table);
  out.subclass("AcDbSymbolTableRecord");
  out.subclass(subclass);
}

void empty_table(DxfGroups& out, const char* name, std::uint32_t handle) {
  begin_table(out, name, handle, 0);
  end_table(out);
}

// The window that programs open the drawing in: all of it.
void viewport_table(DxfGroups& out, const DxfExtent& extent) {
  const Eigen::Vector2d middle = (extent.low + extent.high) / 2.0, size = extent.high - extent.low;
  constexpr double kAspect = 1.5, kAir = 1.05;
  const double height = std::max({size.y(), size.x() / kAspect, 1.0}) * kAir;
  begin_table(out, "VPORT", kViewports, 1);
  begin_entry(out, "VPORT", kViewports, "AcDbViewportTableRecord");
  out.text(2, "*ACTIVE");
  out.integer(70, 0);
  out.point(10, 0.0, 0.0);
  out.point(11, 1.0, 1.0);
  out.point(12, middle.x(), middle.y());
  out.point(13, 0.0, 0.0);
  out.point(14, 10.0, 10.0);
  out.point(15, 10.0, 10.0);
  out.point(16, 0.0, 0.0, 1.0);
  out.point(17, 0.0, 0.0, 0.0);
  out.real(40, height);
  out.real(41, kAspect);
  out.real(42, 50.0);
  for (const int code : {43, 44, 50, 51}) out.real(code, 0.0);
  for (const auto& [code, value] :
       {std::pair{71, 0}, {72, 1000}, {73, 1}, {74, 3}, {75, 0}, {76, 0}, {77, 0}, {78, 0}})
    out.integer(code, value);
  end_table(out);
}

void line_types(DxfGroups& out) {
  struct Entry {
    const char *name, *description;
    std::uint32_t handle;
  };
  std::vector<Entry> entries{{"Continuous", "Solid line", kContinuous}};
  if (out.handles()) entries.insert(entries.begin(), {{"ByBlock", "", kByBlock}, {"ByLayer", "", kByLayer}});
  begin_table(out, "LTYPE", kLineTypes, static_cast<int>(entries.size()));
  for (const Entry& entry : entries) {
    out.record("LTYPE", kLineTypes, entry.handle);
    out.subclass("AcDbSymbolTableRecord");
    out.subclass("AcDbLinetypeTableRecord");
    out.text(2, out.handles() ? entry.name : "CONTINUOUS");
    out.integer(70, 0);
    out.text(3, entry.description);
    out.integer(72, 65);
    out.integer(73, 0);
    out.real(40, 0.0);
  }
  end_table(out);
}

void layers(DxfGroups& out) {
  begin_table(out, "LAYER", kLayers, static_cast<int>(kFileLayers.size()) + 1);
  const auto layer = [&](std::string_view name, int colour) {
    begin_entry(out, "LAYER", kLayers, "AcDbLayerTableRecord");
    out.text(2, name);
    out.integer(70, 0);
    out.integer(62, colour);
    out.text(6, out.handles() ? "Continuous" : "CONTINUOUS");
  };
  layer("0", 7);
  for (const FileLayer& l : kFileLayers) layer(l.name, l.dxf_colour);
  end_table(out);
}

void text_styles(DxfGroups& out) {
  begin_table(out, "STYLE", kStyles, 1);
  out.record("STYLE", kStyles, kStandardStyle);
  out.subclass("AcDbSymbolTableRecord");
  out.subclass("AcDbTextStyleTableRecord");
  out.text(2, out.handles() ? "Standard" : "STANDARD");
  out.integer(70, 0);
  out.real(40, 0.0);
  out.real(41, 1.0);
  out.real(50, 0.0);
  out.integer(71, 0);
  out.real(42, 2.5);
  out.text(3, "txt");
  out.text(4, "");
  end_table(out);
}

void applications(DxfGroups& out) {
  begin_table(out, "APPID", kApplications, 1);
  begin_entry(out, "APPID", kApplications, "AcDbRegAppTableRecord");
  out.text(2, "ACAD");
  out.integer(70, 0);
  end_table(out);
}

void dimension_styles(DxfGroups& out) {
  begin_table(out, "DIMSTYLE", kDimensionStyles, 1);
  out.subclass("AcDbDimStyleTable");
  if (out.handles()) out.integer(71, 0);
  out.record("DIMSTYLE", kDimensionStyles, 105);
  out.subclass("AcDbSymbolTableRecord");
  out.subclass("AcDbDimStyleTableRecord");
  out.text(2, out.handles() ? "Standard" : "STANDARD");
  out.integer(70, 0);
  if (out.handles()) out.handle(340, kStandardStyle);
  end_table(out);
}

void block_records(DxfGroups& out) {
  begin_table(out, "BLOCK_RECORD", kBlockRecords, 2);
  for (const auto& [name, handle] :
       {std::pair{"*Model_Space", kModelSpaceRecord}, {"*Paper_Space", kPaperSpaceRecord}}) {
    out.record("BLOCK_RECORD", kBlockRecords, handle);
    out.subclass("AcDbSymbolTableRecord");
    out.subclass("AcDbBlockTableRecord");
    out.text(2, name);
    out.handle(340, 0);
  }
  end_table(out);
}

void header_point(DxfGroups& out, const char* name, const Eigen::Vector2d& p) {
  out.text(9, name);
  out.point(10, p.x(), p.y(), 0.0);
}

}  // namespace

DxfExtent dxf_extent(const Drawing& drawing) {
  DxfExtent extent{Eigen::Vector2d::Zero(), {drawing.width, drawing.height}};
  for (const DrawingLine& line : drawing.lines) {
    if (line.points.rows() == 0) continue;
    extent.low = extent.low.cwiseMin(line.points.colwise().minCoeff().transpose());
    extent.high = extent.high.cwiseMax(line.points.colwise().maxCoeff().transpose());
  }
  for (const DrawingText& text : drawing.texts) {
    extent.low = extent.low.cwiseMin(text.at);
    extent.high = extent.high.cwiseMax(text.at);
  }
  return extent;
}

void write_dxf_header(DxfGroups& out, const DxfExtent& extent, std::uint32_t next_handle) {
  out.begin_section("HEADER");
  const auto text = [&](const char* name, int code, const char* value) {
    out.text(9, name);
    out.text(code, value);
  };
  const auto integer = [&](const char* name, int value) {
    out.text(9, name);
    out.integer(70, value);
  };
  text("$ACADVER", 1, out.handles() ? "AC1015" : "AC1009");
  text("$DWGCODEPAGE", 3, "ANSI_1252");
  if (out.handles()) {
    out.text(9, "$HANDSEED");
    out.handle(5, next_handle);
  }
  header_point(out, "$INSBASE", Eigen::Vector2d::Zero());
  header_point(out, "$EXTMIN", extent.low);
  header_point(out, "$EXTMAX", extent.high);
  for (const auto& [name, p] : {std::pair{"$LIMMIN", extent.low}, {"$LIMMAX", extent.high}}) {
    out.text(9, name);
    out.point(10, p.x(), p.y());
  }
  integer("$INSUNITS", 4);     // mm
  integer("$MEASUREMENT", 1);  // metric
  integer("$LUNITS", 2);       // decimal
  integer("$LUPREC", 4);
  out.end_section();
}

void write_dxf_tables(DxfGroups& out, const DxfExtent& extent) {
  if (out.handles()) {
    out.begin_section("CLASSES");
    out.end_section();
  }
  out.begin_section("TABLES");
  viewport_table(out, extent);
  line_types(out);
  layers(out);
  text_styles(out);
  empty_table(out, "VIEW", kViews);
  empty_table(out, "UCS", kUcs);
  applications(out);
  if (out.handles()) {
    dimension_styles(out);
    block_records(out);
  }
  out.end_section();
}

void write_dxf_blocks(DxfGroups& out) {
  out.begin_section("BLOCKS");
  if (out.handles()) {
    struct Block {
      const char* name;
      std::uint32_t record, begin, end;
      bool paper;
    };
    for (const Block& block :
         {Block{"*Model_Space", kModelSpaceRecord, kModelSpaceBegin, kModelSpaceEnd, false},
          Block{"*Paper_Space", kPaperSpaceRecord, kPaperSpaceBegin, kPaperSpaceEnd, true}}) {
      const auto head = [&](const char* type, std::uint32_t own, const char* subclass) {
        out.record(type, block.record, own);
        out.subclass("AcDbEntity");
        if (block.paper) out.integer(67, 1);
        out.text(8, "0");
        out.subclass(subclass);
      };
      head("BLOCK", block.begin, "AcDbBlockBegin");
      out.text(2, block.name);
      out.integer(70, 0);
      out.point(10, 0.0, 0.0, 0.0);
      out.text(3, block.name);
      out.text(1, "");
      head("ENDBLK", block.end, "AcDbBlockEnd");
    }
  }
  out.end_section();
}

void write_dxf_objects(DxfGroups& out) {
  if (!out.handles()) return;
  out.begin_section("OBJECTS");
  out.record("DICTIONARY", 0, kRootDictionary);
  out.subclass("AcDbDictionary");
  out.integer(281, 1);
  out.text(3, "ACAD_GROUP");
  out.handle(350, kGroupDictionary);
  out.record("DICTIONARY", kRootDictionary, kGroupDictionary);
  out.subclass("AcDbDictionary");
  out.integer(281, 1);
  out.end_section();
}

}  // namespace planewright
