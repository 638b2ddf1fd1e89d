#include "core/certify/certificate.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/certify/design_checks.h"
#include "core/certify/drawing_checks.h"
#include "core/certify/dxf_reader.h"
#include "core/certify/file_bytes.h"
#include "core/certify/mesh_checks.h"
#include "core/certify/obj_reader.h"
#include "core/certify/package_reader.h"
#include "core/certify/pdf_checks.h"
#include "core/certify/ply_reader.h"
#include "core/certify/scene_reader.h"
#include "core/certify/schedule_checks.h"
#include "core/certify/svg_reader.h"

namespace planewright {
namespace {

bool all_pass(const std::vector<Check>& checks) {
  return std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.pass; });
}

std::string json_reader_name() {
  return "nlohmann json " + std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
         std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." + std::to_string(NLOHMANN_JSON_VERSION_PATCH);
}

class Certifier {
 public:
  Certifier(const std::filesystem::path& folder, const ExportContent& content)
      : folder_(folder), content_(content) {}

  FileCertificate file(const ExportedFile& exported) {
    FileCertificate certificate{exported.name, {}, {}};
    switch (exported.kind) {
      case FileKind::SheetDxf:
        dxf(exported, certificate);
        break;
      case FileKind::SheetSvg:
        svg(exported, certificate);
        break;
      case FileKind::SheetsPdf:
        pdf(exported, certificate);
        break;
      case FileKind::PanelCsv:
      case FileKind::EdgeCsv:
        csv(exported, certificate);
        break;
      case FileKind::ScheduleJson:
        json(exported, certificate);
        break;
      case FileKind::PanelMesh:
      case FileKind::SolidMesh:
        mesh(exported, certificate);
        break;
    }
    return certificate;
  }

  // What all drawings of a kind show together.
  void together(std::vector<FileCertificate>& files) const {
    if (dxf_there_)
      files.push_back({"all DXF files together", dxf_reader_name(), check_all_parts(dxf_, content_)});
    if (svg_there_)
      files.push_back({"all SVG files together", svg_reader_name(), check_all_parts(svg_, content_)});
  }

 private:
  std::filesystem::path path(const ExportedFile& exported) const { return folder_ / exported.name; }

  // The first check of every file; false: nothing more can be checked.
  template <class T>
  static bool readable(const Result<T>& read, FileCertificate& certificate) {
    certificate.checks.push_back({"readable", read.has_value(), read ? "whole" : read.error().text()});
    return read.has_value();
  }

  const Drawing* drawing(const ExportedFile& exported, FileCertificate& certificate) const {
    const bool there = exported.drawing >= 0 && exported.drawing < static_cast<int>(content_.drawings.size());
    if (!there) certificate.checks.push_back({"drawing", false, "no drawing belongs to this file"});
    return there ? &content_.drawings[static_cast<size_t>(exported.drawing)] : nullptr;
  }
  static void append(std::vector<Check> more, FileCertificate& certificate) {
    std::move(more.begin(), more.end(), std::back_inserter(certificate.checks));
  }

  void dxf(const ExportedFile& exported, FileCertificate& certificate) {
    certificate.reader = dxf_reader_name();
    dxf_there_ = true;
    const auto read = read_dxf(path(exported));
    if (!readable(read, certificate)) return;
    certificate.checks.push_back({"both readers agree", read->disagreements.empty(),
                                  read->disagreements.empty()
                                      ? "lines, layers, texts, coordinates to dime's single precision"
                                      : read->disagreements.front()});
    dxf_.push_back(shown_parts(read->drawing));
    if (const Drawing* wanted = drawing(exported, certificate))
      append(check_drawing(read->drawing, content_, *wanted), certificate);
  }
  void svg(const ExportedFile& exported, FileCertificate& certificate) {
    certificate.reader = svg_reader_name();
    svg_there_ = true;
    const auto read = read_svg(path(exported));
    if (!readable(read, certificate)) return;
    svg_.push_back(shown_parts(*read));
    if (const Drawing* wanted = drawing(exported, certificate))
      append(check_drawing(*read, content_, *wanted), certificate);
  }
  void pdf(const ExportedFile& exported, FileCertificate& certificate) const {
    certificate.reader = pdf_reader_name();
    const auto read = read_pdf(path(exported));
    if (readable(read, certificate)) append(check_pdf(*read, content_), certificate);
  }
  void csv(const ExportedFile& exported, FileCertificate& certificate) const {
    certificate.reader = "own RFC 4180";
    const auto bytes = file_bytes(path(exported));
    const auto read = bytes.and_then([&](const std::string& text) { return read_csv(text, exported.name); });
    if (!readable(read, certificate)) return;
    append(exported.kind == FileKind::PanelCsv ? check_panel_csv(*read, content_)
                                               : check_edge_csv(*read, content_),
           certificate);
  }
  void json(const ExportedFile& exported, FileCertificate& certificate) const {
    certificate.reader = json_reader_name();
    const auto bytes = file_bytes(path(exported));
    const auto checks = bytes.and_then(
        [&](const std::string& text) { return check_schedule_json(text, content_, exported.name); });
    if (readable(checks, certificate)) append(*checks, certificate);
  }
  void mesh(const ExportedFile& exported, FileCertificate& certificate) const {
    const auto format = mesh_format_of(exported.name);
    if (!format) {
      certificate.checks.push_back({"readable", false, "no reader knows this ending"});
      return;
    }
    const bool obj = *format == MeshFileFormat::Obj, ply = *format == MeshFileFormat::Ply;
    const bool package = *format == MeshFileFormat::ThreeMf;
    certificate.reader = obj       ? obj_reader_name()
                         : ply     ? ply_reader_name()
                         : package ? "minizip and libxml2 (single precision)"
                                   : scene_reader_name() + " (single precision)";
    const auto read = obj       ? read_obj_file(path(exported))
                      : ply     ? read_ply_file(path(exported))
                      : package ? read_package(path(exported))
                                : read_scene(path(exported));
    if (!readable(read, certificate)) return;
    if (exported.kind == FileKind::PanelMesh) {
      append(check_panel_mesh(*read, *format, content_), certificate);
    } else if (content_.solids) {
      append(check_solid_mesh(*read, *format, content_), certificate);
    } else {
      certificate.checks.push_back({"solids", false, "there are no solids that the file could hold"});
    }
  }

  const std::filesystem::path& folder_;
  const ExportContent& content_;
  std::vector<ShownParts> dxf_, svg_;
  bool dxf_there_ = false, svg_there_ = false;
};

}  // namespace

bool FileCertificate::pass() const {
  return !checks.empty() && all_pass(checks);
}

bool Certificate::pass() const {
  return all_pass(design) &&
         std::all_of(files.begin(), files.end(), [](const FileCertificate& f) { return f.pass(); });
}

Certificate certify(const std::filesystem::path& folder, const std::vector<ExportedFile>& files,
                    const ExportContent& content, const std::function<void(int, int)>& progress,
                    const std::stop_token& stop) {
  Certificate certificate;
  Certifier certifier(folder, content);
  const int total = static_cast<int>(files.size()) + 1;
  int done = 0;
  const auto report = [&] {
    if (progress) progress(done, total);
  };
  report();
  certificate.design = check_design(content);
  ++done;
  for (const ExportedFile& file : files) {
    if (stop.stop_requested()) return certificate;
    report();
    certificate.files.push_back(certifier.file(file));
    ++done;
  }
  certifier.together(certificate.files);
  report();
  return certificate;
}

}  // namespace planewright
