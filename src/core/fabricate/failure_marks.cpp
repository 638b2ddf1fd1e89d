#include "core/fabricate/failure_marks.h"

#include <cmath>
#include <map>

namespace planewright {
namespace {

constexpr double kSize = 0.6;   // of the name's height
constexpr double kBelow = 1.2;  // name heights from the middle of the name to that of the mark

// What each failing panel fails, each kind once.
std::map<int, std::string> failed_kinds(const ToleranceVerdicts& verdicts) {
  std::map<int, std::string> kinds;
  std::map<int, ToleranceKind> last;  // failures are sorted by panel, then kind
  for (const ToleranceFailure& failure : verdicts.failures) {
    const auto seen = last.find(failure.panel);
    if (seen != last.end() && seen->second == failure.kind) continue;
    last[failure.panel] = failure.kind;
    std::string& text = kinds[failure.panel];
    text += (text.empty() ? "FAILS: " : ", ") + std::string(tolerance_name(failure.kind));
  }
  return kinds;
}

}  // namespace

void mark_failures(Drawing& drawing, const ToleranceVerdicts& verdicts) {
  const std::map<int, std::string> kinds = failed_kinds(verdicts);
  std::vector<DrawingText> marks;
  for (const DrawingText& text : drawing.texts) {
    const auto found = kinds.find(text.panel);
    if (!text.is_name || found == kinds.end()) continue;
    DrawingText mark = text;
    mark.text = found->second;
    mark.is_name = false;
    mark.height = kSize * text.height;
    mark.at += kBelow * text.height * Eigen::Vector2d(std::sin(text.rotation), -std::cos(text.rotation));
    marks.push_back(std::move(mark));
  }
  drawing.texts.insert(drawing.texts.end(), marks.begin(), marks.end());
}

}  // namespace planewright
