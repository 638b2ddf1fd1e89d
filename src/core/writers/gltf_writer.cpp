// format_gltf(), with tinygltf; the one place that compiles its code.
#include <algorithm>
#include <cstring>
#include <fstream>  // tiny_gltf.h uses it without saying so
#include <map>
#include <sstream>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

#include "core/writers/clean_text.h"
#include "core/writers/solid_parts.h"

namespace planewright {
namespace {

constexpr double kMetres = 1e-3;  // of a millimetre

// x, y, z with z up become x, z, -y with y up.
Vector3d turned(const Vector3d& p) {
  return {p.x(), p.z(), -p.y()};
}

template <class T>
int add_view(tinygltf::Model& gltf, const std::vector<T>& values, int target) {
  std::vector<unsigned char>& bytes = gltf.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = values.size() * sizeof(T);
  view.target = target;
  bytes.resize(bytes.size() + view.byteLength);
  std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
  gltf.bufferViews.push_back(std::move(view));
  return static_cast<int>(gltf.bufferViews.size()) - 1;
}

void add_part(tinygltf::Model& gltf, const SolidPart& part, const Vector3d& origin) {
  // Single precision: corners relative to the part's middle, where its node stands.
  const Vector3d place = part_place(part.points, origin), middle = place - origin;
  std::vector<float> positions;
  std::vector<double> low(3, 1e300), high(3, -1e300);
  for (Eigen::Index i = 0; i < part.points.rows(); ++i) {
    const Vector3d p = turned(part.points.row(i).transpose() - middle) * kMetres;
    for (size_t axis = 0; axis < 3; ++axis) {
      const float value = static_cast<float>(p[static_cast<int>(axis)]);
      positions.push_back(value);
      low[axis] = std::min(low[axis], static_cast<double>(value));
      high[axis] = std::max(high[axis], static_cast<double>(value));
    }
  }
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : triangles_of(part.points, part.faces))
    for (const int corner : triangle) corners.push_back(static_cast<std::uint32_t>(corner));

  const auto add_accessor = [&](int view, int component, int type, size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    gltf.accessors.push_back(std::move(accessor));
    return static_cast<int>(gltf.accessors.size()) - 1;
  };
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  const int position_view = add_view(gltf, positions, TINYGLTF_TARGET_ARRAY_BUFFER);
  const int position =
      add_accessor(position_view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, positions.size() / 3);
  gltf.accessors.back().minValues = low;
  gltf.accessors.back().maxValues = high;
  primitive.attributes["POSITION"] = position;
  const int corner_view = add_view(gltf, corners, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  primitive.indices =
      add_accessor(corner_view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, corners.size());

  tinygltf::Mesh mesh;
  mesh.name = part.name;
  mesh.primitives.push_back(std::move(primitive));
  gltf.meshes.push_back(std::move(mesh));
  tinygltf::Node node;
  node.name = part.name;
  node.mesh = static_cast<int>(gltf.meshes.size()) - 1;
  const Vector3d stands = turned(place) * kMetres;
  node.translation = {stands.x(), stands.y(), stands.z()};
  gltf.nodes.push_back(std::move(node));
  gltf.scenes[0].nodes.push_back(static_cast<int>(gltf.nodes.size()) - 1);
}

}  // namespace

Result<std::string> format_gltf(const SolidScene& scene) {
  if (scene.parts.empty())
    return fail(ErrorCode::Refused, "there is no part to write", "glTF", "It holds no empty scene");
  tinygltf::Model gltf;
  gltf.asset.version = "2.0";
  gltf.asset.generator = "Planewright";
  gltf.buffers.emplace_back();
  gltf.scenes.emplace_back();
  gltf.scenes[0].name = clean_text(scene.model->title);
  gltf.defaultScene = 0;
  tinygltf::Material material;
  material.name = "panel";
  material.doubleSided = scene.surface;
  material.pbrMetallicRoughness.baseColorFactor = {0.72, 0.76, 0.80, 1.0};
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = 0.6;
  gltf.materials.push_back(std::move(material));
  for (const SolidPart& part : scene.parts) add_part(gltf, part, scene.model->origin);

  std::ostringstream stream;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&gltf, stream, false, true) || !stream)
    return fail(ErrorCode::Refused, "tinygltf could not write the scene", "glTF",
                "Write the panels in another format");
  return std::move(stream).str();
}

}  // namespace planewright
