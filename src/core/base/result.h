// Result and Error: how every fallible operation of the core reports what a user can cause.
//
// Errors that a user can cause (files, settings, infeasible demands) are values of type Error, with a code that
// maps to an exit status, what happened, where (file:line or element), and what to do about it. Exceptions are
// kept for bugs. Threads: plain values, no shared state.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace planewright {

// What kind of thing went wrong. The command line turns it into its exit status (see src/cli/exit_status.h).
enum class ErrorCode {
  Usage,        // an option or a setting that does not exist or contradicts another
  Unreadable,   // a file that is missing, cannot be opened, or does not parse
  Unwritable,   // a file that could not be written; whatever stood there before is untouched
  Refused,      // input that was read but cannot be worked on (no faces, only degenerate ones, ...)
  Infeasible,   // demands that cannot be met together
  Unavailable,  // the machine lacks something (no OpenGL, out of memory)
};

struct Error {
  ErrorCode code = ErrorCode::Refused;
  std::string what;    // one sentence: what is wrong
  std::string where;   // "roof.obj:14", "face 17", "--offset"; may be empty
  std::string remedy;  // one sentence: what the user can do; may be empty

  // "where: what. remedy" with the empty parts left out.
  std::string text() const;
};

template <class T>
using Result = tl::expected<T, Error>;

// return fail(ErrorCode::Unreadable, "the file ends inside face 12", "roof.off:512", "export it again");
inline tl::unexpected<Error> fail(ErrorCode code, std::string what, std::string where = {}, std::string remedy = {}) {
  return tl::unexpected<Error>(Error{code, std::move(what), std::move(where), std::move(remedy)});
}

}  // namespace planewright
