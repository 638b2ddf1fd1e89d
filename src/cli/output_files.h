// Checks of the files that a command is about to write, before it does any work.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace planewright::cli {

struct NamedFile {
  std::string option;  // "IN", "-o": what the user knows it by
  std::string path;    // empty: not given
};

// Every output can be written now, and none is also an input or another output. Fails with ErrorCode::Usage
// for files that coincide (first), ErrorCode::Unwritable else.
Result<void> check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace planewright::cli
