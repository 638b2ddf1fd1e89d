#include "cli/output_files.h"

#include "core/base/atomic_file.h"

namespace planewright::cli {

Result<void> check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  std::vector<NamedFile> others = inputs;
  for (const NamedFile& output : outputs) {
    if (output.path.empty()) continue;
    for (const NamedFile& other : others)
      if (!other.path.empty() && same_file(output.path, other.path))
        return fail(ErrorCode::Usage, output.option + " and " + other.option + " are the same file",
                    output.path, "Name another file to write to");
    others.push_back(output);
  }
  for (const NamedFile& output : outputs)
    if (!output.path.empty())
      if (auto writable = check_writable(output.path); !writable) return writable;
  return {};
}

}  // namespace planewright::cli
