// Values of a schedule against the passports', collected row by row. Internal to certify/. Threads: pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/certify/certificate.h"

namespace planewright {

// The whole text as a number.
std::optional<double> number_in(std::string_view text);

class ValueCheck {
 public:
  // written: empty where the file has nothing; wanted: empty where it should not.
  void compare(const std::string& who, std::string_view what, const std::optional<double>& written,
               const std::optional<double>& wanted);
  void compare(const std::string& who, std::string_view what, std::string_view written,
               std::string_view wanted);
  Check check(std::string name) const;

 private:
  long long compared_ = 0;
  double largest_ = 0.0;
  std::vector<std::string> wrong_;
};

}  // namespace planewright
