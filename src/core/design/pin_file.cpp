#include "core/design/pin_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

constexpr const char* kForms =
    "Write 'vertex N x y z', 'face N x y z', 'edge N x y z', 'edge A B x y z', 'corner N x y z', 'plane "
    "vertex "
    "N' or 'plane face N' with or without 'nx ny nz d'; '-' leaves a coordinate free, '*' takes the wanted "
    "one";

// The rest of a line.
std::vector<std::string_view> rest_of_line(TextScanner& scanner) {
  std::vector<std::string_view> tokens;
  while (true) {
    const std::string_view token = scanner.token_in_line();
    if (token.empty()) return tokens;
    tokens.push_back(token);
  }
}

Result<int> read_element(const TextScanner& scanner, std::string_view token, const char* kind, int count) {
  const auto number = to_integer(token);
  if (!number) return scanner.error(in_quotes(token) + " is not the number of an element", kForms);
  if (*number < 0 || *number >= count)
    return scanner.error("there is no " + std::string(kind) + " " + std::to_string(*number),
                         count > 0 ? "Numbers go from 0 to " + std::to_string(count - 1) : std::string());
  return static_cast<int>(*number);
}

Result<double> read_number(const TextScanner& scanner, std::string_view token) {
  const auto value = to_number(token);
  if (!value || !std::isfinite(*value))
    return scanner.error(in_quotes(token) + " is not a finite number", kForms);
  return *value;
}

Result<PinFile::Plane> read_plane(const TextScanner& scanner, const std::vector<std::string_view>& tokens,
                                  const PolygonMesh& mesh) {
  if (tokens.empty() || (tokens[0] != "vertex" && tokens[0] != "face"))
    return scanner.error("'plane' is followed by 'vertex' or 'face'", kForms);
  if (tokens.size() != 2 && tokens.size() != 6)
    return scanner.error("a plane has an element, or an element and four numbers", kForms);
  PinFile::Plane plane{tokens[0] == "vertex", 0, std::nullopt, scanner.where()};
  const auto element = plane.of_vertex ? read_element(scanner, tokens[1], "vertex", mesh.vertex_count())
                                       : read_element(scanner, tokens[1], "face", mesh.face_count());
  if (!element) return tl::unexpected(element.error());
  plane.element = *element;
  if (tokens.size() == 2) return plane;
  std::array<double, 4> numbers{};
  for (size_t k = 0; k < 4; ++k) {
    const auto number = read_number(scanner, tokens[k + 2]);
    if (!number) return tl::unexpected(number.error());
    numbers[k] = *number;
  }
  if (numbers[0] == 0.0 && numbers[1] == 0.0 && numbers[2] == 0.0)
    return scanner.error("the plane's normal is 0 0 0", "Give a normal of positive length");
  plane.plane = {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  return plane;
}

// Which point a line means; takes its tokens off the front.
Result<PointOrigin> read_origin(const TextScanner& scanner, std::string_view word,
                                std::vector<std::string_view>& tokens, const PolygonMesh& mesh) {
  const bool by_ends = word == "edge" && tokens.size() == 5;  // edge A B x y z
  if (tokens.size() != 4 && !by_ends)
    return scanner.error("a pin has an element and three coordinates", kForms);
  const bool vertices = word == "vertex" || word == "corner" || by_ends;
  const int count = vertices ? mesh.vertex_count() : word == "face" ? mesh.face_count() : mesh.edge_count();
  const char* kind = vertices ? "vertex" : word == "face" ? "face" : "edge";
  auto element = read_element(scanner, tokens[0], kind, count);
  if (!element) return tl::unexpected(element.error());
  if (by_ends) {
    const auto end = read_element(scanner, tokens[1], kind, count);
    if (!end) return tl::unexpected(end.error());
    const int edge = mesh.find_edge(*element, *end);
    if (edge < 0)
      return scanner.error(
          "no edge joins vertices " + std::string(tokens[0]) + " and " + std::string(tokens[1]),
          "Name two vertices of one edge");
    element = edge;
    tokens.erase(tokens.begin());
  }
  tokens.erase(tokens.begin());
  const PointKind point = word == "vertex"   ? PointKind::Vertex
                          : word == "corner" ? PointKind::Corner
                          : word == "face"   ? PointKind::Face
                                             : PointKind::BorderEdge;
  return PointOrigin{point, *element};
}

Result<PinFile::Point> read_point(const TextScanner& scanner, std::string_view word,
                                  std::vector<std::string_view> tokens, const PolygonMesh& mesh) {
  const auto origin = read_origin(scanner, word, tokens, mesh);
  if (!origin) return tl::unexpected(origin.error());
  PinFile::Point pin{*origin, {}, scanner.where()};
  for (size_t axis = 0; axis < 3; ++axis) {
    if (tokens[axis] == "-") continue;
    if (tokens[axis] == "*") {
      pin.at[axis].kind = PinCoordinate::Kind::Wanted;
      continue;
    }
    const auto value = read_number(scanner, tokens[axis]);
    if (!value) return tl::unexpected(value.error());
    pin.at[axis] = {PinCoordinate::Kind::Given, *value};
  }
  if (std::all_of(pin.at.begin(), pin.at.end(),
                  [](const PinCoordinate& c) { return c.kind == PinCoordinate::Kind::Free; }))
    return scanner.error("the pin holds no coordinate", "Give at least one of x, y, z");
  return pin;
}

std::string describe(const PointOrigin& origin) {
  const std::string number = std::to_string(origin.element);
  switch (origin.kind) {
    case PointKind::Face:
      return "face " + number;
    case PointKind::BorderEdge:
      return "edge " + number;
    case PointKind::Corner:
      return "corner " + number;
    case PointKind::Vertex:
      return "vertex " + number;
  }
  return number;
}

const char* points_there_are(ComplexKind kind) {
  return kind == ComplexKind::Dual
             ? "A dual has a point for each face, border edge and border vertex ('corner')"
         : kind == ComplexKind::Planarize
             ? "When planarizing there is a point at each vertex that a face uses"
             : "Panels of clusters have a point at each vertex that is a corner of three regions, or of two "
               "at the border";
}

}  // namespace

Result<PinFile> parse_pin_file(std::string_view content, const std::string& name, const PolygonMesh& mesh) {
  PinFile file;
  TextScanner scanner(content, name, {.hash_comments = true});
  while (!scanner.at_end()) {
    const std::string_view word = scanner.token_in_line();
    if (word == "plane") {
      auto plane = read_plane(scanner, rest_of_line(scanner), mesh);
      if (!plane) return tl::unexpected(plane.error());
      file.planes.push_back(std::move(*plane));
    } else if (word == "vertex" || word == "face" || word == "edge" || word == "corner") {
      auto point = read_point(scanner, word, rest_of_line(scanner), mesh);
      if (!point) return tl::unexpected(point.error());
      file.points.push_back(std::move(*point));
    } else {
      return scanner.error(in_quotes(word) + " is no kind of pin", kForms);
    }
    scanner.skip_line();
  }
  return file;
}

Result<void> add_pins(const PinFile& file, const TangentComplex& complex, Demands& demands) {
  std::map<std::pair<int, int>, int> point_of;
  for (int j = 0; j < complex.point_count(); ++j) {
    const PointOrigin& origin = complex.point_origin[static_cast<size_t>(j)];
    point_of[{static_cast<int>(origin.kind), origin.element}] = j;
  }
  Demands added = demands;
  struct Held {
    double value;
    const PinFile::Point* line;
  };
  std::map<std::pair<int, size_t>, Held> held;  // by point and axis
  for (const PinFile::Point& line : file.points) {
    const auto point = point_of.find({static_cast<int>(line.point.kind), line.point.element});
    if (point == point_of.end())
      return fail(ErrorCode::Unreadable, "these panels have no point of " + describe(line.point), line.where,
                  points_there_are(complex.kind));
    Pin pin{line.point, {}};
    for (size_t axis = 0; axis < 3; ++axis) {
      const int column = static_cast<int>(axis);
      if (line.at[axis].kind == PinCoordinate::Kind::Free) continue;
      const double value = line.at[axis].kind == PinCoordinate::Kind::Given
                               ? line.at[axis].value
                               : complex.preferred(point->second, column) + complex.origin[column];
      const auto [before, is_new] = held.insert({{point->second, axis}, {value, &line}});
      // Equal up to rounding is no contradiction; '*' is a sum.
      if (!is_new && std::abs(before->second.value - value) > 1e-9 * complex.mean_edge)
        return fail(ErrorCode::Infeasible,
                    "the pins of " + before->second.line->where + " and " + line.where + " hold " +
                        describe(line.point) + " at different places",
                    line.where, "Remove one of the two");
      pin.at[axis] = value;
    }
    added.pins.push_back(pin);
  }
  const bool of_vertices = complex.kind == ComplexKind::Dual;
  std::map<int, const PinFile::Plane*> plane_lines;
  for (const PinFile::Plane& line : file.planes) {
    const auto& origins = complex.plane_origin;
    // Of clusters a panel is named by any face of its region.
    const int origin = complex.kind == ComplexKind::Cluster && !line.of_vertex
                           ? complex.region_of_face[static_cast<size_t>(line.element)]
                           : line.element;
    if (line.of_vertex != of_vertices || std::find(origins.begin(), origins.end(), origin) == origins.end())
      return fail(ErrorCode::Unreadable,
                  "these panels have none of " + std::string(line.of_vertex ? "vertex " : "face ") +
                      std::to_string(line.element),
                  line.where,
                  of_vertices                              ? "The panels of a dual belong to vertices"
                  : complex.kind == ComplexKind::Planarize ? "When planarizing, panels are the faces"
                                                           : "Name a face of the region");
    if (const auto [before, is_new] = plane_lines.insert({origin, &line});
        !is_new && before->second->plane != line.plane)
      return fail(ErrorCode::Infeasible,
                  "the pins of " + before->second->where + " and " + line.where +
                      " hold one panel in different planes",
                  line.where, "Remove one of the two");
    added.plane_pins.push_back({origin, line.plane});
  }
  demands = std::move(added);
  return {};
}

}  // namespace planewright
