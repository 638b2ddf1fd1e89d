// The scale of a slider for a number of things: logarithmic from the least to the most, whole numbers.
//
// Threads: pure functions. 1 <= least <= most.
#pragma once

namespace planewright::ui {

// The number at a fraction (0..1) of the slider's travel.
int count_at(double fraction, int least, int most);
// Where a number stands; those outside the scale stand at its ends.
double fraction_of_count(int count, int least, int most);
// One notch of the wheel up (+1) or down (-1): about a twentieth, at least one; stays on the scale.
int count_step(int count, double notches, int least, int most);

}  // namespace planewright::ui
