// The word of a list that a mistyped one is nearest to. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planewright {

// By number of letters put in, taken out or exchanged; of equally near ones the first. Empty: no words.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

}  // namespace planewright
