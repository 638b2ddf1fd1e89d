#include "cli/export_options.h"

#include <charconv>
#include <cmath>

#include "cli/finite_number.h"
#include "cli/named_choice.h"
#include "core/base/atomic_file.h"

namespace planewright::cli {
namespace {

// "3210x6000", mm
Result<SheetSize> parse_sheet(const std::string& text) {
  const auto bad = [&] {
    return fail(ErrorCode::Usage, "'" + text + "' is no size of a sheet", "--sheet",
                "Give its sides in mm, such as 3210x6000, or 'none' for no sheets");
  };
  const char* end = text.data() + text.size();
  SheetSize size;
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return bad();
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  if (height.ec != std::errc() || height.ptr != end) return bad();
  if (!(size.width > 0.0 && size.height > 0.0 && std::isfinite(size.width) && std::isfinite(size.height)))
    return bad();
  return size;
}

// A number that may not be given; mm, kg/m3, m2 or degrees.
CLI::Option* limit(CLI::App& command, const std::string& name, std::optional<double>& value,
                   const std::string& text) {
  return command.add_option(name, value, text)->check(finite_number())->check(not_negative());
}

void set(std::optional<double>& limit, const std::optional<double>& given) {
  if (given) limit = given;
}

Result<void> check_order(const std::optional<double>& least, const std::optional<double>& most,
                         const std::string& what) {
  if (!least || !most || *least <= *most) return {};
  return fail(ErrorCode::Usage, "the smallest " + what + " allowed is above the largest",
              "--" + what + "-min, --" + what + "-max");
}

}  // namespace

void declare_export_options(CLI::App& command, const std::shared_ptr<ExportOptions>& options) {
  ExportOptions& o = *options;
  command.add_option("IN", o.input, "Panels: a mesh (.obj .off .ply .stl) or a project (.planewright)")
      ->required();
  command.add_option("-o", o.folder, "Folder to write to; made if it is not there")->required();
  command
      .add_option("--format", o.formats,
                  "dxf, svg, pdf, csv, json, obj, ply, stl, 3mf, gltf, or all; several with commas")
      ->delimiter(',')
      ->required();
  command.add_option("--unit", o.unit, "What one unit of IN is: mm, cm, m, in, ft. Needed for a mesh");
  command.add_option("--layer", o.layer, "Which layer of a project (default: the first)");

  const std::string sizes = "Sizes";
  command.add_option("--thickness", o.thickness, "Of a panel, mm; mitred solids and patterns follow")
      ->check(finite_number())
      ->group(sizes);
  limit(command, "--gap", o.gap, "Between neighbouring panels, mm")->group(sizes);
  limit(command, "--density", o.density, "kg/m3, for weights (glass 2500, aluminium 2700)")->group(sizes);
  command.add_option("--sheet", o.sheet, "Stock sheets, mm: 3210x6000; 'none': all parts in rows")
      ->group(sizes);
  command.add_option("--spacing", o.nesting.spacing, "Between parts on a sheet, mm (default: 10)")
      ->check(finite_number())
      ->check(not_negative())
      ->group(sizes);
  command.add_option("--margin", o.nesting.margin, "Along the border of a sheet, mm (default: 10)")
      ->check(finite_number())
      ->check(not_negative())
      ->group(sizes);
  command.add_flag("!--no-rotate", o.nesting.rotate, "Parts keep their up side up on the sheet")
      ->group(sizes);

  const std::string tolerances = "Tolerances";
  command.add_option("--tolerances", o.tolerances, "Tolerance sheet (JSON); the options below go before it")
      ->group(tolerances);
  limit(command, "--planarity", o.planarity, "Corner off its panel's plane, mm at most (default: 0.5)")
      ->group(tolerances);
  limit(command, "--distance", o.distance, "Corner off the reference surface, mm at most")->group(tolerances);
  command.add_option("--reference", o.reference, "Surface that --distance refers to, in the unit of IN")
      ->group(tolerances);
  limit(command, "--edge-min", o.edge_min, "Edge length, mm")->group(tolerances);
  limit(command, "--edge-max", o.edge_max, "Edge length, mm")->group(tolerances);
  limit(command, "--area-min", o.area_min, "Area, m2")->group(tolerances);
  limit(command, "--area-max", o.area_max, "Area, m2")->group(tolerances);
  limit(command, "--interior-min", o.interior_min, "Angle at a corner, degrees")->group(tolerances);
  limit(command, "--interior-max", o.interior_max, "Angle at a corner, degrees")->group(tolerances);
  limit(command, "--dihedral-min", o.dihedral_min, "Angle between neighbours, degrees, 180: flat")
      ->group(tolerances);
  limit(command, "--dihedral-max", o.dihedral_max, "Angle between neighbours, degrees, 180: flat")
      ->group(tolerances);
  command
      .add_option("--on-failure", o.on_failure,
                  "Panels that fail: 'mark' them and write all (default), or 'refuse' to write")
      ->transform(named_choice<OnFailure>({{"mark", OnFailure::Mark}, {"refuse", OnFailure::Refuse}}))
      ->group(tolerances);
  command
      .add_option("--congruent", o.congruence.tolerance, "Panels this near are one class, mm (default: 0.1)")
      ->check(finite_number())
      ->check(not_negative())
      ->group(tolerances);

  const std::string names = "Names and drawings";
  command.add_option("--names", o.names, "'rows': C-17 (default); 'plain': 17")
      ->transform(named_choice<NameStyle>({{"rows", NameStyle::RowLetter}, {"plain", NameStyle::Plain}}))
      ->group(names);
  command.add_option("--keep-names", o.keep_names, "schedule.json of an earlier export whose names go on")
      ->group(names);
  command.add_option("--up", o.up, "Axis that is up: z (default), y or x")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->group(names);
  command.add_flag("--engrave-names", o.labels.engrave_names, "Names as single strokes to engrave as well")
      ->group(names);
  command
      .add_flag("!--no-edge-names", o.labels.edge_names, "Leave out the neighbours' names along the edges")
      ->group(names);
  command.add_option("--text-height", o.labels.text_height, "Of names, mm at most (default: 12)")
      ->check(finite_number())
      ->check(positive_number())
      ->group(names);
  command.add_option("--dxf", o.dxf, "r2000 (default) or r12")
      ->transform(named_choice<DxfVersion>({{"r2000", DxfVersion::R2000}, {"r12", DxfVersion::R12}}))
      ->group(names);
  command.add_option("--title", o.title.project, "Title block: project")->group(names);
  command.add_option("--drawn-by", o.title.drawn_by, "Title block: name")->group(names);
  command.add_option("--date", o.title.date, "Title block: date")->group(names);
  command.add_option("--note", o.title.note, "Title block: note")->group(names);

  command.add_flag("--overwrite", o.overwrite, "Replace files of an earlier export in the folder");
  command.add_flag("--quiet", o.quiet, "No progress");
}

Result<WorkshopContract> contract_of(const ExportOptions& options, WorkshopContract project) {
  WorkshopContract contract = std::move(project);
  if (!options.unit.empty()) {
    const auto unit = parse_length_unit(options.unit, "--unit");
    if (!unit) return tl::unexpected(unit.error());
    contract.unit = *unit;
  }
  if (!options.tolerances.empty()) {
    const auto text = read_file(options.tolerances);
    if (!text) return tl::unexpected(text.error());
    auto sheet = read_tolerance_sheet(*text, options.tolerances);
    if (!sheet) return tl::unexpected(sheet.error());
    contract.tolerances = *sheet;
  }
  ToleranceSheet& sheet = contract.tolerances;
  set(sheet.planarity, options.planarity);
  set(sheet.distance, options.distance);
  set(sheet.edge_min, options.edge_min);
  set(sheet.edge_max, options.edge_max);
  set(sheet.area_min, options.area_min);
  set(sheet.area_max, options.area_max);
  set(sheet.interior_min, options.interior_min);
  set(sheet.interior_max, options.interior_max);
  set(sheet.dihedral_min, options.dihedral_min);
  set(sheet.dihedral_max, options.dihedral_max);
  for (const auto& checked : {check_order(sheet.edge_min, sheet.edge_max, "edge"),
                              check_order(sheet.area_min, sheet.area_max, "area"),
                              check_order(sheet.interior_min, sheet.interior_max, "interior"),
                              check_order(sheet.dihedral_min, sheet.dihedral_max, "dihedral")})
    if (!checked) return tl::unexpected(checked.error());
  if (options.sheet == "none") {
    sheet.stock.reset();
  } else if (!options.sheet.empty()) {
    const auto size = parse_sheet(options.sheet);
    if (!size) return tl::unexpected(size.error());
    sheet.stock = *size;
  }
  if (options.thickness) {
    if (!(*options.thickness > 0.0))
      return fail(ErrorCode::Usage, "a panel of this thickness cannot be made", "--thickness",
                  "Give more than 0 mm, or leave it out for panels without thickness");
    contract.thickness = *options.thickness;
  }
  if (options.gap) contract.gap = *options.gap;
  if (options.density) contract.density = *options.density;
  if (options.names) contract.names = *options.names;
  return contract;
}

Result<ExportSettings> export_settings(const ExportOptions& options, const WorkshopContract& contract) {
  auto formats = parse_export_formats(options.formats, "--format");
  if (!formats) return tl::unexpected(formats.error());
  ExportSettings settings;
  settings.formats = std::move(*formats);
  // "all" is all that can be made.
  if (contract.thickness <= 0.0 &&
      std::find(options.formats.begin(), options.formats.end(), "all") != options.formats.end())
    settings.formats.erase(ExportFormat::ThreeMf);
  settings.tolerances = contract.tolerances;
  settings.on_failure = options.on_failure;
  settings.thickness = contract.thickness;
  settings.gap = contract.gap;
  settings.density = contract.density;
  settings.congruence = options.congruence;
  if (contract.tolerances.stock) {
    settings.nesting = options.nesting;
    settings.nesting->sheet = *contract.tolerances.stock;
  }
  settings.labels = options.labels;
  settings.dxf = options.dxf;
  settings.pdf.title = options.title;
  settings.overwrite = options.overwrite;
  return settings;
}

}  // namespace planewright::cli
