#include "core/certify/package_reader.h"

#include <libxml/xmlreader.h>
#include <minizip/unzip.h>

#include <array>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace planewright {
namespace {

struct ClosePackage {
  void operator()(void* package) const { unzClose(package); }
};
struct FreeReader {
  void operator()(xmlTextReader* reader) const { xmlFreeTextReader(reader); }
};
struct FreeText {
  void operator()(xmlChar* text) const { xmlFree(text); }
};

// The bytes of the entry that minizip stands at; nothing if they do not unpack.
std::optional<std::string> unpacked(unzFile package) {
  if (unzOpenCurrentFile(package) != UNZ_OK) return {};
  std::string bytes;
  std::string buffer(1 << 16, '\0');
  int got = 0;
  while ((got = unzReadCurrentFile(package, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0)
    bytes.append(buffer.data(), static_cast<size_t>(got));
  const bool sound = unzCloseCurrentFile(package) == UNZ_OK;  // checks the sum
  if (got < 0 || !sound) return {};
  return bytes;
}

std::optional<std::string> attribute(xmlTextReader* reader, const char* name) {
  const std::unique_ptr<xmlChar, FreeText> text(
      xmlTextReaderGetAttribute(reader, reinterpret_cast<const xmlChar*>(name)));
  if (!text) return {};
  return std::string(reinterpret_cast<const char*>(text.get()));
}

struct Object {
  std::string name;
  std::vector<Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};
struct Item {
  std::string object;
  std::array<double, 12> transform{1, 0, 0, 0, 1, 0,
                                   0, 0, 1, 0, 0, 0};  // rows act on (x, y, z, 1) from the left
};
struct Model {
  std::string unit = "millimeter";        // the default of 3MF
  std::map<std::string, Object> objects;  // by id
  std::vector<Item> items;
};

// Numbers with spaces between; false if there are not just as many as `values`.
template <class Number, std::size_t Count>
bool numbers(const std::string& text, std::array<Number, Count>& values) {
  const char* at = text.data();
  const char* end = at + text.size();
  for (Number& value : values) {
    while (at != end && *at == ' ') ++at;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc()) return false;
    at = read.ptr;
  }
  while (at != end && *at == ' ') ++at;
  return at == end;
}

// What is wrong with the element that the reader stands at; nothing if it was taken.
std::optional<std::string> take(xmlTextReader* reader, Model& model, Object*& object) {
  const std::string_view element = reinterpret_cast<const char*>(xmlTextReaderConstLocalName(reader));
  const auto of = [&](const char* name) { return attribute(reader, name).value_or(""); };
  if (element == "model") {
    model.unit = attribute(reader, "unit").value_or(model.unit);
  } else if (element == "object") {
    object = &model.objects[of("id")];
    object->name = of("name");
  } else if (element == "vertex" && object) {
    std::array<double, 3> p{};
    if (!numbers(of("x") + " " + of("y") + " " + of("z"), p)) return "a vertex is not three numbers";
    object->vertices.emplace_back(p[0], p[1], p[2]);
  } else if (element == "triangle" && object) {
    std::array<int, 3> corners{};
    if (!numbers(of("v1") + " " + of("v2") + " " + of("v3"), corners))
      return "a triangle has no three corners";
    object->triangles.push_back(corners);
  } else if (element == "item") {
    Item item{of("objectid")};
    const auto transform = attribute(reader, "transform");
    if (transform && !numbers(*transform, item.transform)) return "a transform is not twelve numbers";
    model.items.push_back(std::move(item));
  } else if (element == "component") {
    return "it has components, which are not read";
  }
  return {};
}

Result<Model> scanned(const std::string& text, const std::string& name) {
  const auto bad = [&](std::string what) { return fail(ErrorCode::Unreadable, std::move(what), name); };
  const std::unique_ptr<xmlTextReader, FreeReader> reader(
      xmlReaderForMemory(text.data(), static_cast<int>(text.size()), nullptr, nullptr,
                         XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE));
  if (!reader) return bad("its model is no XML");
  Model model;
  Object* object = nullptr;
  int read = 0;
  while ((read = xmlTextReaderRead(reader.get())) == 1) {
    if (xmlTextReaderNodeType(reader.get()) != XML_READER_TYPE_ELEMENT) continue;
    if (auto wrong = take(reader.get(), model, object)) return bad(*std::move(wrong));
  }
  if (read != 0) return bad("its model is no XML");
  return model;
}

// The items of the build, each an object of its own.
Result<ReadMesh> built(const Model& model, const std::string& name) {
  const auto bad = [&](std::string what) { return fail(ErrorCode::Unreadable, std::move(what), name); };
  ReadMesh mesh;
  mesh.unit = model.unit;
  mesh.single_precision = true;  // as lib3mf keeps them
  std::vector<double> coordinates;
  for (const Item& item : model.items) {
    const auto found = model.objects.find(item.object);
    if (found == model.objects.end()) return bad("an item is of no object");
    const Object& object = found->second;
    const int first = static_cast<int>(coordinates.size() / 3),
              count = static_cast<int>(object.vertices.size());
    const std::array<double, 12>& t = item.transform;
    for (const Vector3d& p : object.vertices)
      for (std::size_t c = 0; c < 3; ++c)
        coordinates.push_back(t[c] * p.x() + t[3 + c] * p.y() + t[6 + c] * p.z() + t[9 + c]);
    for (std::array<int, 3> corners : object.triangles) {
      for (int& corner : corners) {
        if (corner < 0 || corner >= count) return bad("a triangle has a corner that is not there");
        corner += first;
      }
      mesh.faces.push_back(corners);
      mesh.object_of_face.push_back(static_cast<int>(mesh.objects.size()));
    }
    mesh.objects.push_back(object.name);
  }
  if (mesh.faces.empty()) return bad("no faces");
  mesh.points =
      Eigen::Map<const Points>(coordinates.data(), static_cast<Eigen::Index>(coordinates.size() / 3), 3);
  if (!mesh.points.allFinite()) return bad("a coordinate is not finite");
  return mesh;
}

}  // namespace

Result<ReadMesh> read_package(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::unique_ptr<void, ClosePackage> package(unzOpen64(path.c_str()));
  if (!package) return fail(ErrorCode::Unreadable, "it is no package", name);
  for (int at = unzGoToFirstFile(package.get()); at == UNZ_OK; at = unzGoToNextFile(package.get())) {
    std::string entry(512, '\0');
    if (unzGetCurrentFileInfo64(package.get(), nullptr, entry.data(), entry.size() - 1, nullptr, 0, nullptr,
                                0) != UNZ_OK)
      break;
    entry.resize(entry.find('\0'));
    if (!entry.ends_with(".model")) continue;
    const auto bytes = unpacked(package.get());
    if (!bytes) return fail(ErrorCode::Unreadable, "its model does not unpack", name);
    const auto model = scanned(*bytes, name);
    if (!model) return tl::unexpected(model.error());
    return built(*model, name);
  }
  return fail(ErrorCode::Unreadable, "no model in the package", name);
}

}  // namespace planewright
