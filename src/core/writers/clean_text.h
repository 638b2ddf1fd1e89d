// Text of users on its way to a file: any bytes in, valid UTF-8 of one line out. Internal to writers/.
// Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planewright {

// The characters of UTF-8 text; bytes that are none become U+FFFD, control characters (line ends, tabs)
// blanks.
std::vector<char32_t> clean_characters(std::string_view text);
// The same as UTF-8.
std::string clean_text(std::string_view text);

}  // namespace planewright
