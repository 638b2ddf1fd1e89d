#include "core/base/result.h"

namespace planewright {
namespace {

bool ends_sentence(char c) {
  return c == '.' || c == '?' || c == '!';
}

}  // namespace

std::string Error::text() const {
  std::string out;
  if (!where.empty()) out += where + ": ";
  out += what;
  if (!remedy.empty()) out += (out.empty() || ends_sentence(out.back()) ? " " : ". ") + remedy;
  if (!out.empty() && !ends_sentence(out.back())) out += '.';
  return out;
}

}  // namespace planewright
