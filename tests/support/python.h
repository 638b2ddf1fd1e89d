// Readers of Python's for files that ours wrote: so that no test reads with the writer's own eyes.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/atomic_file.h"
#include "support/temporary_folder.h"

namespace planewright::test {

// An interpreter that has the module; empty: none has. Debian's own is asked first.
inline std::string python_with(const std::string& module) {
  for (const std::string python : {"/usr/bin/python3", "python3"})
    if (std::system((python + " -c 'import " + module + "' >/dev/null 2>&1").c_str()) == 0) return python;
  return {};
}

// What `script` prints as JSON when given the path of a file with these bytes; null, with a failure, if it
// fails.
inline nlohmann::json read_with_python(const std::string& python, const std::string& script,
                                       const std::string& bytes, const std::string& file_name) {
  const TemporaryFolder folder;
  const auto file = folder.write(file_name, bytes), code = folder.write("read.py", script),
             out = folder / "out.json", errors = folder / "errors.txt";
  const std::string command =
      python + " " + code.string() + " " + file.string() + " >" + out.string() + " 2>" + errors.string();
  if (std::system(command.c_str()) != 0) {
    ADD_FAILURE() << read_file(errors).value_or("no output");
    return {};
  }
  return nlohmann::json::parse(read_file(out).value_or(""), nullptr, false);
}

}  // namespace planewright::test
