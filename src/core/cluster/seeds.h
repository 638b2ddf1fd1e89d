// Where regions start: one face each, at least one in every component. Internal to this folder.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/cluster/face_graph.h"

namespace planewright {

// A number in 0..count-1, each as likely, the same on every platform (std::uniform_int_distribution is not).
int draw_below(std::mt19937& random, int count);

// `count` distinct faces, ascending. Preconditions: #components <= count <= #F.
std::vector<int> random_seeds(const FaceGraph& graph, int count, std::uint32_t seed_number);

// Each the face farthest from those before by |n - m|^2 + 4 pi |x - y|^2: on a sphere both terms are equal.
// In the order found; O(count #F).
std::vector<int> farthest_seeds(const FaceGraph& graph, int count);

}  // namespace planewright
