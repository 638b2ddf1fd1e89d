#include "core/certify/mesh_frame.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/certify/check_text.h"

namespace planewright {
namespace {

constexpr double kMetre = 1000.0;  // mm

double to_millimetres(MeshFileFormat format) {
  return format == MeshFileFormat::Gltf ? kMetre : 1.0;
}

bool says_millimetres(std::string_view text) {
  for (const std::string_view word : {"mm", "millimetre", "millimetres", "millimeter", "millimeters"})
    for (size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const auto letter = [&](size_t i) {
        return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i]));
      };
      if (!(at > 0 && letter(at - 1)) && !letter(at + word.size())) return true;
    }
  return false;
}

// The farthest of a's points from the nearest of b's, which are sorted by x first.
double farthest(const Points& a, const Points& b) {
  std::vector<int> order(static_cast<size_t>(b.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return b(i, 0) < b(j, 0); });
  double worst = 0.0;
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const auto middle =
        std::lower_bound(order.begin(), order.end(), a(i, 0), [&](int k, double x) { return b(k, 0) < x; });
    double best = std::numeric_limits<double>::infinity();
    for (auto at = middle; at != order.end() && b(*at, 0) - a(i, 0) < best; ++at)
      best = std::min(best, (b.row(*at) - a.row(i)).norm());
    for (auto at = middle; at != order.begin() && a(i, 0) - b(*(at - 1), 0) < best; --at)
      best = std::min(best, (b.row(*(at - 1)) - a.row(i)).norm());
    worst = std::max(worst, best);
  }
  return worst;
}

}  // namespace

std::optional<MeshFileFormat> mesh_format_of(std::string_view file) {
  std::string ending(file.substr(std::min(file.rfind('.'), file.size())));
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".obj") return MeshFileFormat::Obj;
  if (ending == ".ply") return MeshFileFormat::Ply;
  if (ending == ".stl") return MeshFileFormat::Stl;
  if (ending == ".3mf") return MeshFileFormat::ThreeMf;
  if (ending == ".gltf" || ending == ".glb") return MeshFileFormat::Gltf;
  return {};
}

Points in_model_frame(const ReadMesh& mesh, MeshFileFormat format, const WorkshopModel& model) {
  if (format == MeshFileFormat::Stl) return mesh.points;
  Points points = mesh.points;
  if (format == MeshFileFormat::Gltf) {
    // y up, z towards the viewer, back to z up.
    points.col(0) = kMetre * mesh.points.col(0);
    points.col(1) = -kMetre * mesh.points.col(2);
    points.col(2) = kMetre * mesh.points.col(1);
  }
  return points.rowwise() - model.origin.transpose();
}

double coordinate_limit(const ReadMesh& mesh, MeshFileFormat format) {
  const double largest =
      mesh.points.size() ? mesh.points.cwiseAbs().maxCoeff() * to_millimetres(format) : 0.0;
  // Rounded by the writer, by the reader, and by what a reader's fast decimals lose; three coordinates.
  if (mesh.single_precision) return std::max(1e-6, 6.0 * std::numeric_limits<float>::epsilon() * largest);
  return std::max(1e-6, 16.0 * std::numeric_limits<double>::epsilon() * largest);
}

Check scale_check(const ReadMesh& mesh, MeshFileFormat format, const Points& points, const Points& wanted) {
  const double ratio = bounding_diagonal(points) / bounding_diagonal(wanted);
  bool says = true;
  std::string unit;
  switch (format) {
    case MeshFileFormat::Obj:
    case MeshFileFormat::Ply:
      says = says_millimetres(mesh.unit);
      unit = says ? "millimetres, by a comment" : "no comment says the unit";
      break;
    case MeshFileFormat::ThreeMf:
      says = mesh.unit == "millimeter";
      unit = "unit " + mesh.unit;
      break;
    case MeshFileFormat::Gltf:
      unit = "metres, by the standard";
      break;
    case MeshFileFormat::Stl:
      unit = "STL knows no unit, read as millimetres";
      break;
  }
  return {"scale", says && std::abs(ratio - 1.0) <= 1e-6,
          unit + "; size of the file / size of the model = 1 + (" + brief(ratio - 1.0) + ")"};
}

MeshObjects objects_by_name(const ReadMesh& mesh, const std::vector<int>& wanted,
                            const WorkshopModel& model) {
  MeshObjects objects;
  objects.faces_of_panel.resize(static_cast<size_t>(model.panel_count()));
  std::map<std::string, int> panel_of, times;
  for (const int p : wanted) panel_of[model.names[static_cast<size_t>(p)]] = p;
  std::vector<std::string> wrong;
  std::vector<int> panel_of_object;
  std::vector<bool> has_faces(mesh.objects.size(), false);
  for (const int object : mesh.object_of_face)
    if (object >= 0 && object < static_cast<int>(has_faces.size()))
      has_faces[static_cast<size_t>(object)] = true;
  for (size_t k = 0; k < mesh.objects.size(); ++k) {
    const std::string& name = mesh.objects[k];
    const auto found = panel_of.find(name);
    panel_of_object.push_back(found == panel_of.end() ? -1 : found->second);
    // PLY numbers panels; a number that the file leaves out is no object.
    if (name.empty() && !has_faces[k]) continue;
    if (found == panel_of.end())
      wrong.push_back("'" + name + "' is no panel here");
    else
      ++times[name];
  }
  size_t loose = 0;
  for (int f = 0; f < mesh.faces.size(); ++f) {
    const int object = mesh.object_of_face[static_cast<size_t>(f)];
    const bool named = object >= 0 && object < static_cast<int>(panel_of_object.size());
    if (!named)
      ++loose;
    else if (const int p = panel_of_object[static_cast<size_t>(object)]; p >= 0)
      objects.faces_of_panel[static_cast<size_t>(p)].push_back(f);
  }
  int right = 0;
  for (const int p : wanted) {
    const std::string& name = model.names[static_cast<size_t>(p)];
    if (times[name] == 1 && !objects.faces_of_panel[static_cast<size_t>(p)].empty())
      ++right;
    else
      wrong.push_back(name + (times[name] > 1 ? " more than once" : " is missing"));
  }
  if (loose > 0) wrong.push_back(counted(static_cast<long long>(loose)) + " faces of no panel");
  std::string detail = counted(right) + " of " + counted(static_cast<long long>(wanted.size())) + " names";
  if (!wrong.empty()) detail += "; " + listed(wrong);
  objects.check = {"every name once", wrong.empty(), detail};
  return objects;
}

double set_distance(const Points& a, const Points& b) {
  if (a.rows() == 0 || b.rows() == 0) return std::numeric_limits<double>::infinity();
  return std::max(farthest(a, b), farthest(b, a));
}

}  // namespace planewright
