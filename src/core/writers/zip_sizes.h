// Packages of lib3mf as every reader takes them. Internal to writers/.
//
// lib3mf writes sizes as zip64 whatever they are; minizip, and so assimp and the slicers built on them, finds
// no model in such a package. Threads: pure.
#pragma once

#include <string>

namespace planewright {

// Puts sizes and offsets below 4 GB where headers had them before zip64; larger ones stay. What is no such
// package is given back as it is.
std::string with_plain_sizes(std::string package);

}  // namespace planewright
