// format_obj(), format_ply(): polygons as text.
#include "core/writers/clean_text.h"
#include "core/writers/number_text.h"
#include "core/writers/solid_parts.h"

namespace planewright {
namespace {

void append_point(std::string& out, const Vector3d& p) {
  append_number(out, p.x());
  out += ' ';
  append_number(out, p.y());
  out += ' ';
  append_number(out, p.z());
  out += '\n';
}

void append_points(std::string& out, const char* prefix, const Points& points, const Vector3d& origin) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    out += prefix;
    append_point(out, points.row(i).transpose() + origin);
  }
}

int count_points(const SolidScene& scene) {
  if (scene.surface) return static_cast<int>(scene.model->points.rows());
  Eigen::Index count = 0;
  for (const SolidPart& part : scene.parts) count += part.points.rows();
  return static_cast<int>(count);
}

// Calls visit(part, its faces, number of the first point that they count from).
template <class Visit>
void for_each_part(const SolidScene& scene, Visit&& visit) {
  int first = 0;
  for (const SolidPart& part : scene.parts) {
    if (scene.surface) {
      Polygons shared;
      shared.push_back(scene.model->panels[part.panel]);
      visit(part, shared, 0);
    } else {
      visit(part, part.faces, first);
      first += static_cast<int>(part.points.rows());
    }
  }
}

}  // namespace

std::string format_obj(const SolidScene& scene) {
  std::string out = "# Planewright: " + clean_text(scene.model->title) + "\n# units: mm\n";
  if (scene.surface) append_points(out, "v ", scene.model->points, scene.model->origin);
  for_each_part(scene, [&](const SolidPart& part, const Polygons& faces, int first) {
    // A group of one surface, or an object of its own.
    out += (scene.surface ? "g " : "o ") + part.name + '\n';
    if (!scene.surface) append_points(out, "v ", part.points, scene.model->origin);
    for (int f = 0; f < faces.size(); ++f) {
      out += 'f';
      for (const int corner : faces[f]) {
        out += ' ';
        append_number(out, first + corner + 1);
      }
      out += '\n';
    }
  });
  return out;
}

std::string format_ply(const SolidScene& scene) {
  int faces = 0;
  for (const SolidPart& part : scene.parts) faces += part.faces.size();
  std::string out = "ply\nformat ascii 1.0\ncomment Planewright: " + clean_text(scene.model->title) +
                    "\ncomment units: mm\n";
  for (const SolidPart& part : scene.parts) {
    out += "comment panel ";
    append_number(out, part.panel);
    out += ' ' + part.name + '\n';
  }
  out += "element vertex " + std::to_string(count_points(scene)) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(faces) +
         "\nproperty list int int vertex_indices\nproperty int panel\nend_header\n";
  if (scene.surface)
    append_points(out, "", scene.model->points, scene.model->origin);
  else
    for (const SolidPart& part : scene.parts) append_points(out, "", part.points, scene.model->origin);
  for_each_part(scene, [&](const SolidPart& part, const Polygons& list, int first) {
    for (int f = 0; f < list.size(); ++f) {
      append_number(out, list.valence(f));
      for (const int corner : list[f]) {
        out += ' ';
        append_number(out, first + corner);
      }
      out += ' ';
      append_number(out, part.panel);
      out += '\n';
    }
  });
  return out;
}

}  // namespace planewright
