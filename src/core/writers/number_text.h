// Numbers as text, the same in every locale, with as many digits as bring back every double exactly.
// Internal to writers/. Precondition of the doubles: finite (std::invalid_argument else, a bug of ours: no
// file may ever hold "nan"). Threads: pure.
#pragma once

#include <string>

namespace planewright {

void append_number(std::string& out, int value);
// Shortest text that reads back as the same double; without exponent where a sensible length allows. -0 is 0.
void append_number(std::string& out, double value);
// Rounded to `decimals` places, for people.
void append_rounded(std::string& out, double value, int decimals);

std::string number_text(double value);
std::string rounded_text(double value, int decimals);

}  // namespace planewright
