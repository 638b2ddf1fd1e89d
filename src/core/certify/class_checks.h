// Whether classes of congruent panels are what they say, measured without the code that made them. Internal
// to certify/. Threads: pure.
#pragma once

#include "core/certify/certificate.h"

namespace planewright {

// Every panel in one class, its mother as she lies. Of every other member, with its corners on the mother's
// as its shift and its being mirrored say: all distances between two corners within twice the tolerance of
// the mother's (corners that lie on each other within it differ by no more), and where bevels count, those
// agree, or are none for one that is mirrored. content.classes must be there.
Check check_classes(const ExportContent& content);

}  // namespace planewright
