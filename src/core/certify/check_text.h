// How checks are worded: numbers, and lists of names that stay short. Internal to certify/. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planewright {

std::string counted(long long n);  // "1,053"
std::string brief(double value);   // three digits: "2.3e-11"

// "A-01, A-02, A-03 and 12 more"
std::string listed(const std::vector<std::string>& names);

// "largest difference 2.3e-11 mm (limit 1e-06 mm)"
std::string against_limit(double difference, double limit, std::string_view unit);

}  // namespace planewright
