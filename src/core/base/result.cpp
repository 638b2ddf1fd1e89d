#include "core/base/result.h"

namespace planewright {

std::string Error::text() const {
  std::string out;
  if (!where.empty()) out += where + ": ";
  out += what;
  if (!remedy.empty()) out += (out.empty() || out.back() == '.' ? " " : ". ") + remedy;
  if (!out.empty() && out.back() != '.') out += '.';
  return out;
}

}  // namespace planewright
