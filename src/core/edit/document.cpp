#include "core/edit/document.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace planewright {
namespace {

// Why PolygonMesh::can_flip said no, as a sentence for the designer.
Error refusal(const PolygonMesh& mesh, int edge) {
  const std::string where = "edge " + std::to_string(edge);
  const MeshEdge e = mesh.edge(edge);
  if (e.border()) {
    return {ErrorCode::Refused, "an edge of the border cannot be flipped", where, "Click an inner edge."};
  }
  const Polygons faces = mesh.faces();
  if (faces.valence(e.left) != 3 || faces.valence(e.right) != 3) {
    return {ErrorCode::Refused, "only an edge between two triangles can be flipped", where,
            "Triangulate the two faces first."};
  }
  const auto opposite = [&](int face) {
    for (const int v : faces[face]) {
      if (v != e.a && v != e.b) return v;
    }
    return -1;
  };
  if (mesh.find_edge(opposite(e.left), opposite(e.right)) >= 0) {
    return {ErrorCode::Refused, "the flipped edge exists already", where, "Flip a neighbouring edge first."};
  }
  return {ErrorCode::Refused, "the flip would leave a vertex with too few faces", where,
          "Flip a neighbouring edge first."};
}

}  // namespace

void Document::open(CheckedMesh mesh, std::string name, LayerSettings settings) {
  mesh_ = std::make_shared<const PolygonMesh>(std::move(mesh.mesh));
  health_ = std::move(mesh.health);
  name_ = std::move(name);
  design_ = Design{};
  design_.layers.front().settings = std::move(settings);
  active_layer_ = 0;
  steps_.clear();
  done_ = 0;
  merging_ = false;
  ++revision_;
}

Result<void> Document::may_flip(int edge) const {
  if (!mesh_) return fail(ErrorCode::Refused, "there is no mesh yet", {}, "Open one first.");
  if (edge < 0 || edge >= mesh_->edge_count()) {
    return fail(ErrorCode::Refused, "there is no such edge", "edge " + std::to_string(edge));
  }
  if (!mesh_->can_flip(edge)) return tl::unexpected<Error>(refusal(*mesh_, edge));
  return {};
}

Result<void> Document::flip_edge(int edge) {
  if (Result<void> allowed = may_flip(edge); !allowed) return allowed;
  auto flipped = std::make_shared<PolygonMesh>(*mesh_);
  [[maybe_unused]] const bool done = flipped->flip(edge);
  assert(done);
  push({"Flip edge " + std::to_string(edge), {}, mesh_, std::move(flipped), design_, design_});
  return {};
}

void Document::set_active_layer(int layer) {
  active_layer_ = std::clamp(layer, 0, static_cast<int>(design_.layers.size()) - 1);
}

void Document::change_settings(LayerSettings settings, std::string what, std::string merge_key) {
  Design design = design_;
  design.layers[static_cast<std::size_t>(active_layer_)].settings = std::move(settings);
  change_design(std::move(design), std::move(what), std::move(merge_key));
}

void Document::change_design(Design design, std::string what, std::string merge_key) {
  assert(!design.layers.empty());
  if (design == design_) return;
  const bool merges = merging_ && !merge_key.empty() && done_ > 0 && done_ == steps_.size() &&
                      steps_.back().merge_key == merge_key;
  if (!merges) {
    merging_ = !merge_key.empty();
    push({std::move(what), std::move(merge_key), mesh_, mesh_, design_, std::move(design)});
    return;
  }
  Step& step = steps_.back();
  step.design_after = std::move(design);
  apply(mesh_, step.design_after);
  if (step.design_after == step.design_before) {  // dragged back to where it began
    steps_.pop_back();
    done_ = steps_.size();
    merging_ = false;
  }
}

void Document::end_merge() {
  merging_ = false;
}

bool Document::can_undo() const {
  return done_ > 0;
}
bool Document::can_redo() const {
  return done_ < steps_.size();
}
std::string Document::undo_name() const {
  return can_undo() ? steps_[done_ - 1].what : std::string();
}
std::string Document::redo_name() const {
  return can_redo() ? steps_[done_].what : std::string();
}

void Document::undo() {
  if (!can_undo()) return;
  merging_ = false;
  const Step& step = steps_[--done_];
  apply(step.mesh_before, step.design_before);
}

void Document::redo() {
  if (!can_redo()) return;
  merging_ = false;
  const Step& step = steps_[done_++];
  apply(step.mesh_after, step.design_after);
}

void Document::push(Step step) {
  if (step.merge_key.empty()) merging_ = false;
  steps_.resize(done_);
  steps_.push_back(std::move(step));
  done_ = steps_.size();
  apply(steps_.back().mesh_after, steps_.back().design_after);
}

void Document::apply(const std::shared_ptr<const PolygonMesh>& mesh, const Design& design) {
  mesh_ = mesh;
  design_ = design;
  set_active_layer(active_layer_);
  ++revision_;
}

}  // namespace planewright
