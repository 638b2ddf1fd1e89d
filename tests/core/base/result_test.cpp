#include "core/base/result.h"

#include <gtest/gtest.h>

namespace planewright {
namespace {

TEST(Error, TextNamesPlaceProblemAndRemedy) {
  const Error error{ErrorCode::Unreadable, "the file ends inside face 12", "roof.off:512", "Export it again"};
  EXPECT_EQ(error.text(), "roof.off:512: the file ends inside face 12. Export it again.");
}

TEST(Error, TextLeavesOutWhatIsEmpty) {
  EXPECT_EQ((Error{ErrorCode::Refused, "no faces", "", ""}.text()), "no faces.");
  EXPECT_EQ((Error{ErrorCode::Refused, "no faces", "a.obj", ""}.text()), "a.obj: no faces.");
  EXPECT_EQ((Error{ErrorCode::Refused, "no faces", "", "Open another mesh"}.text()),
            "no faces. Open another mesh.");
}

TEST(Error, TextDoublesNoFullStop) {
  EXPECT_EQ((Error{ErrorCode::Refused, "no faces", "", "Is this the file?"}.text()),
            "no faces. Is this the file?");
  EXPECT_EQ((Error{ErrorCode::Refused, "no faces.", "", "Open another mesh."}.text()),
            "no faces. Open another mesh.");
}

TEST(Result, FailCarriesAllParts) {
  const Result<int> result = fail(ErrorCode::Usage, "what", "where", "remedy");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Usage);
  EXPECT_EQ(result.error().what, "what");
  EXPECT_EQ(result.error().where, "where");
  EXPECT_EQ(result.error().remedy, "remedy");
}

}  // namespace
}  // namespace planewright
