// Classes of congruent panels: those that one pattern serves, turned as it likes, and (apart) its mirror
// image.
//
// Two panels belong together if the corners of one can be laid on those of the other, in their cyclic order,
// by a motion of the plane with no corner off by more than the tolerance: the motion that makes the sum of
// squares least, of the cyclic shifts the best, of equally good ones the smallest. Not turned over if that
// will do. "Within a tolerance" is no
// equivalence: classes are made round a first panel (the mother panel), in the order of the panels, and every
// member is within the tolerance of the mother, the first of which that is so. With thickness, the bevels of
// the sides have to agree to `bevel_tolerance` as well, and a mirror image is the same only turned inside
// out, so never a pattern for mitred panels: only for those that are cut square all round (bevels of 0 to
// that tolerance). What panels are off their planes counts for nothing. Units: mm, degrees. Threads: pure.
#pragma once

#include <vector>

#include "core/workshop/panel_passport.h"

namespace planewright {

struct CongruenceOptions {
  double tolerance = 0.1;        // mm
  bool bevels = false;           // whether bevels have to agree
  double bevel_tolerance = 0.1;  // degrees
};

struct CongruenceMember {
  int panel;
  bool mirrored = false;   // lies on the mother turned over
  int shift = 0;           // its corner `shift` lies on the mother's corner 0
  double deviation = 0.0;  // mm, of the farthest corner
};
struct CongruenceClass {
  std::vector<CongruenceMember> members;  // the mother first
};

// Every panel in exactly one class; classes in the order of their mothers.
std::vector<CongruenceClass> congruence_classes(const WorkshopModel& model,
                                                const std::vector<PanelPassport>& passports,
                                                const CongruenceOptions& options = {});

}  // namespace planewright
