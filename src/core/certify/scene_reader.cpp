#include "core/certify/scene_reader.h"

#include <assimp/scene.h>
#include <assimp/version.h>

#include <assimp/Importer.hpp>

#include "core/certify/file_bytes.h"

namespace planewright {
namespace {

class Collector {
 public:
  explicit Collector(const aiScene& scene) : scene_(scene) {}

  ReadMesh collect() {
    walk(*scene_.mRootNode, aiMatrix4x4());
    mesh_.points =
        Eigen::Map<const Points>(coordinates_.data(), static_cast<Eigen::Index>(coordinates_.size() / 3), 3);
    mesh_.single_precision = true;
    return std::move(mesh_);
  }

 private:
  void walk(const aiNode& node, const aiMatrix4x4& above) {
    const aiMatrix4x4 here = above * node.mTransformation;
    if (node.mNumMeshes > 0) {
      const int object = static_cast<int>(mesh_.objects.size());
      mesh_.objects.emplace_back(node.mName.C_Str());
      for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], here, object);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) walk(*node.mChildren[i], here);
  }

  void add(const aiMesh& part, const aiMatrix4x4& place, int object) {
    const int first = static_cast<int>(coordinates_.size() / 3);
    // In double, so that nothing of the part's own digits is lost where it stands far from 0.
    const auto moved = [&](unsigned row, const aiVector3D& p) {
      const auto* m = place[row];
      return static_cast<double>(m[0]) * p.x + static_cast<double>(m[1]) * p.y +
             static_cast<double>(m[2]) * p.z + static_cast<double>(m[3]);
    };
    for (unsigned v = 0; v < part.mNumVertices; ++v)
      for (unsigned row = 0; row < 3; ++row) coordinates_.push_back(moved(row, part.mVertices[v]));
    std::vector<int> corners;
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      corners.clear();
      for (unsigned k = 0; k < part.mFaces[f].mNumIndices; ++k)
        corners.push_back(first + static_cast<int>(part.mFaces[f].mIndices[k]));
      if (corners.size() < 3) continue;  // points and lines bound nothing
      mesh_.faces.push_back(corners);
      mesh_.object_of_face.push_back(object);
    }
  }

  const aiScene& scene_;
  std::vector<double> coordinates_;
  ReadMesh mesh_;
};

}  // namespace

std::string scene_reader_name() {
  return "assimp " + std::to_string(aiGetVersionMajor()) + "." + std::to_string(aiGetVersionMinor()) + "." +
         std::to_string(aiGetVersionPatch());
}

Result<ReadMesh> read_scene(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (const auto bytes = file_bytes(path); !bytes) return tl::unexpected(bytes.error());
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  // To assimp a scene without materials is incomplete; whether faces are missing the checks tell.
  if (!scene || !scene->mRootNode) return fail(ErrorCode::Unreadable, importer.GetErrorString(), name);
  ReadMesh mesh = Collector(*scene).collect();
  if (mesh.faces.empty()) return fail(ErrorCode::Unreadable, "no faces", name);
  if (!mesh.points.allFinite()) return fail(ErrorCode::Unreadable, "a coordinate is not finite", name);
  const std::string ending = path.extension().string();
  if (ending == ".gltf" || ending == ".glb") {
    mesh.unit = "metre";
  } else {
    mesh.objects.clear();  // STL names the file alone
  }
  return mesh;
}

}  // namespace planewright
