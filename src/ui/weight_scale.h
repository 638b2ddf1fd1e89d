// The scale of a weight slider: logarithmic from 0.001 to 1000, with 0 at its left end.
//
// Threads: pure functions. Weights are unit-free.
#pragma once

namespace planewright::ui {

constexpr double kLeastWeight = 1e-3, kMostWeight = 1e3;

// The weight at a fraction (0..1) of the slider's travel, rounded to two digits.
double weight_at(double fraction);
// Where a weight stands; weights outside the scale stand at its ends.
double fraction_of_weight(double weight);
// One notch of the wheel up (+1) or down (-1); below the least weight comes 0.
double weight_step(double weight, double notches);

}  // namespace planewright::ui
