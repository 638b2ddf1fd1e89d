// format_3mf(), with lib3mf.
#include <Model/COM/NMR_DLLInterfaces.h>

#include <cstdint>
#include <string>

#include "core/writers/clean_text.h"
#include "core/writers/solid_parts.h"
#include "core/writers/zip_sizes.h"

namespace planewright {
namespace {

// An object of lib3mf's, given back at the end.
class Handle {
 public:
  Handle() = default;
  ~Handle() {
    if (object_) NMR::lib3mf_release(object_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  NMR::PLib3MFBase* get() const { return object_; }
  NMR::PLib3MFBase** out() { return &object_; }

 private:
  NMR::PLib3MFBase* object_ = nullptr;
};

// The file in memory; lib3mf seeks back to fill in sizes. Its callbacks return 0 where all is well.
struct Buffer {
  std::string bytes;
  size_t at = 0;
};
std::uint32_t write_bytes(const std::uint8_t* data, std::uint32_t count, void* user) {
  Buffer& buffer = *static_cast<Buffer*>(user);
  if (buffer.bytes.size() < buffer.at + count) buffer.bytes.resize(buffer.at + count);
  buffer.bytes.replace(buffer.at, count, reinterpret_cast<const char*>(data), count);
  buffer.at += count;
  return 0;
}
std::uint32_t seek_to(std::uint64_t position, void* user) {
  Buffer& buffer = *static_cast<Buffer*>(user);
  if (buffer.bytes.size() < position) buffer.bytes.resize(position);
  buffer.at = position;
  return 0;
}

tl::unexpected<Error> failed(const Handle& object, const std::string& doing) {
  DWORD code = 0;
  LPCSTR message = nullptr;
  std::string reason = "lib3mf failed";
  if (object.get() && NMR::lib3mf_getlasterror(object.get(), &code, &message) == 0 && message)
    reason = std::string(message) + " (lib3mf error " + std::to_string(code) + ")";
  return fail(ErrorCode::Refused, reason, doing, "Write the solids in another format");
}

Result<void> add_part(const Handle& model, const SolidPart& part, const Vector3d& origin) {
  const std::string where = "3MF, panel " + part.name;
  Handle mesh;
  if (NMR::lib3mf_model_addmeshobject(model.get(), mesh.out()) != 0) return failed(model, where);
  if (NMR::lib3mf_object_setnameutf8(mesh.get(), part.name.c_str()) != 0) return failed(mesh, where);
  if (NMR::lib3mf_object_setpartnumberutf8(mesh.get(), part.name.c_str()) != 0) return failed(mesh, where);

  // Single precision: corners relative to the part's middle, which the build item moves to its place.
  const Vector3d place = part_place(part.points, origin), middle = place - origin;
  std::vector<NMR::MODELMESHVERTEX> vertices(static_cast<size_t>(part.points.rows()));
  for (Eigen::Index i = 0; i < part.points.rows(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      vertices[static_cast<size_t>(i)].m_fPosition[axis] =
          static_cast<float>(part.points(i, axis) - middle[axis]);
  std::vector<NMR::MODELMESHTRIANGLE> triangles;
  for (const auto& cut : triangles_of(part.points, part.faces)) {
    NMR::MODELMESHTRIANGLE& triangle = triangles.emplace_back();
    for (size_t k = 0; k < 3; ++k) triangle.m_nIndices[k] = static_cast<DWORD>(cut[k]);
  }
  if (NMR::lib3mf_meshobject_setgeometry(mesh.get(), vertices.data(), static_cast<DWORD>(vertices.size()),
                                         triangles.data(), static_cast<DWORD>(triangles.size())) != 0)
    return failed(mesh, where);

  NMR::MODELTRANSFORM transform{};
  for (int axis = 0; axis < 3; ++axis) {
    transform.m_fFields[axis][axis] = 1.0f;
    transform.m_fFields[axis][3] = static_cast<float>(place[axis]);
  }
  Handle item;
  if (NMR::lib3mf_model_addbuilditem(model.get(), mesh.get(), &transform, item.out()) != 0)
    return failed(model, where);
  return {};
}

}  // namespace

Result<std::string> format_3mf(const SolidScene& scene) {
  Handle model;
  if (NMR::lib3mf_createmodel(model.out()) != 0) return failed(model, "3MF");
  if (NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER) != 0) return failed(model, "3MF");
  const std::string title = clean_text(scene.model->title);
  for (const auto& [key, value] :
       {std::pair<const char*, std::string>{"Title", title}, {"Application", "Planewright"}})
    if (NMR::lib3mf_model_addmetadatautf8(model.get(), key, value.c_str()) != 0) return failed(model, "3MF");
  for (const SolidPart& part : scene.parts)
    if (auto added = add_part(model, part, scene.model->origin); !added) return tl::unexpected(added.error());

  Handle writer;
  if (NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()) != 0) return failed(model, "3MF");
  Buffer buffer;
  if (NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(&write_bytes),
                                         reinterpret_cast<void*>(&seek_to), &buffer) != 0)
    return failed(writer, "3MF");
  return with_plain_sizes(std::move(buffer.bytes));
}

}  // namespace planewright
