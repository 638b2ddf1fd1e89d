#include "core/certify/dxf_reader.h"

#include <dime/Input.h>
#include <dime/Layer.h>
#include <dime/Model.h>
#include <dime/State.h>
#include <dime/entities/LWPolyline.h>
#include <dime/entities/Line.h>
#include <dime/entities/Polyline.h>
#include <dime/entities/Text.h>
#include <dime/entities/Vertex.h>
#include <dime/records/Record.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "core/certify/dxf_groups.h"
#include "core/certify/file_bytes.h"

namespace planewright {
namespace {

// What dime sees of one entity.
struct Seen {
  std::string layer, text;
  bool closed = false;
  std::vector<Eigen::Vector2d> points;
};
struct SeenAll {
  std::vector<Seen> lines, texts;
};

bool note(const dimeState*, dimeEntity* entity, void* data) {
  auto& all = *static_cast<SeenAll*>(data);
  Seen seen;
  seen.layer = entity->getLayer() ? entity->getLayer()->getLayerName() : "";
  switch (entity->typeId()) {
    case dimeBase::dimeLWPolylineType: {
      const auto* line = static_cast<dimeLWPolyline*>(entity);
      seen.closed = (line->getFlags() & 1) != 0;
      for (int i = 0; i < line->getNumVertices(); ++i)
        seen.points.emplace_back(line->getXCoords()[i], line->getYCoords()[i]);
      all.lines.push_back(std::move(seen));
      break;
    }
    case dimeBase::dimePolylineType: {
      auto* line = static_cast<dimePolyline*>(entity);
      seen.closed = (line->getFlags() & dimePolyline::CLOSED) != 0;
      for (int i = 0; i < line->getNumCoordVertices(); ++i) {
        const dimeVec3f& p = line->getCoordVertex(i)->getCoords();
        seen.points.emplace_back(p[0], p[1]);
      }
      all.lines.push_back(std::move(seen));
      break;
    }
    case dimeBase::dimeLineType: {
      const auto* line = static_cast<dimeLine*>(entity);
      for (int i = 0; i < 2; ++i) seen.points.emplace_back(line->getCoords(i)[0], line->getCoords(i)[1]);
      all.lines.push_back(std::move(seen));
      break;
    }
    case dimeBase::dimeTextType: {
      const auto* text = static_cast<dimeText*>(entity);
      seen.text = text->getTextString() ? text->getTextString() : "";
      all.texts.push_back(std::move(seen));
      break;
    }
    default:
      break;
  }
  return true;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void compare(const ReadDrawing& ours, const SeenAll& dime, std::vector<std::string>& out) {
  const double mm = ours.mm_per_unit.value_or(1.0);
  if (ours.lines.size() != dime.lines.size())
    out.push_back(std::to_string(ours.lines.size()) + " lines by group codes, " +
                  std::to_string(dime.lines.size()) + " by dime");
  if (ours.texts.size() != dime.texts.size())
    out.push_back(std::to_string(ours.texts.size()) + " texts by group codes, " +
                  std::to_string(dime.texts.size()) + " by dime");
  if (!out.empty()) return;
  for (size_t i = 0; i < ours.lines.size(); ++i) {
    const ReadLine& a = ours.lines[i];
    const Seen& b = dime.lines[i];
    const std::string which = "line " + std::to_string(i + 1);
    // A closed line may repeat its first point; ours has it once.
    const size_t repeated = b.closed && b.points.size() > 1 && b.points.front() == b.points.back() ? 1 : 0;
    const auto rows = static_cast<size_t>(a.points.rows());
    if (a.layer != b.layer || a.closed != b.closed ||
        (rows != b.points.size() && rows + repeated != b.points.size())) {
      out.push_back(which + " differs in layer, number of points or being closed");
      continue;
    }
    for (size_t k = 0; k < rows; ++k) {
      const Eigen::Vector2d p = a.points.row(static_cast<Eigen::Index>(k)) / mm;
      const double single = 2.0 * std::numeric_limits<float>::epsilon();
      if (((p - b.points[k]).cwiseAbs().array() > single * p.cwiseAbs().array() + 1e-30).any()) {
        out.push_back(which + " differs in point " + std::to_string(k + 1));
        break;
      }
    }
  }
  for (size_t i = 0; i < ours.texts.size(); ++i)
    if (ours.texts[i].layer != dime.texts[i].layer)
      out.push_back("text " + std::to_string(i + 1) + " differs in layer");
}

}  // namespace

std::string dxf_reader_name() {
  return std::string(dimeModel::getVersionString()) + " and own group codes";
}

Result<ReadDxf> read_dxf(const std::filesystem::path& path) {
  const auto bytes = file_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string name = path.filename().string();
  auto ours = read_dxf_groups(*bytes, name);
  if (!ours) return tl::unexpected(ours.error());

  // Read only after our own reader took the file: dime prints on the terminal what it cannot read.
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  dimeInput input;
  // With its memory handler: without, it loses the arrays of LWPOLYLINEs and frees strings the wrong way.
  dimeModel model(true);
  if (!file || !input.setFileHandle(file.get()) || !model.read(&input))
    return fail(ErrorCode::Unreadable, "dime cannot read it", name);
  SeenAll seen;
  model.traverseEntities(note, &seen, false, true, false);
  ReadDxf read{std::move(*ours), {}};
  compare(read.drawing, seen, read.disagreements);
  return read;
}

}  // namespace planewright
