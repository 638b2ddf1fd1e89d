#include "core/pattern/stroke_font.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace planewright {
namespace {

constexpr double kRows = 6.0, kColumns = 4.0, kAdvance = 6.0;  // of the grid that glyphs are drawn on
constexpr double kSmall = 4.0 / 6.0;                           // of small letters

// Strokes: corners "xy" on the grid, strokes parted by ';'.
std::string_view glyph(char c) {
  switch (c) {
    case 'A':
      return "002640;1333";
    case 'B':
      return "00063645443303;3342413000";
    case 'C':
      return "4536160501103041";
    case 'D':
      return "00062644422000";
    case 'E':
      return "40000646;0333";
    case 'F':
      return "000646;0333";
    case 'G':
      return "45361605011030414323";
    case 'H':
      return "0006;4046;0343";
    case 'I':
      return "1030;2026;1636";
    case 'J':
      return "0110304146";
    case 'K':
      return "0006;460340";
    case 'L':
      return "060040";
    case 'M':
      return "0006234640";
    case 'N':
      return "00064046";
    case 'O':
      return "100105163645413010";
    case 'P':
      return "00063645443303";
    case 'Q':
      return "100105163645413010;2240";
    case 'R':
      return "00063645443303;2340";
    case 'S':
      return "011030414233130405163645";
    case 'T':
      return "0646;2620";
    case 'U':
      return "060110304146";
    case 'V':
      return "062046";
    case 'W':
      return "0610233046";
    case 'X':
      return "0046;0640";
    case 'Y':
      return "062346;2320";
    case 'Z':
      return "06460040";
    case '0':
      return "100105163645413010;1135";
    case '1':
      return "142620;1030";
    case '2':
      return "05163645440040";
    case '3':
      return "05163645443323;334241301001";
    case '4':
      return "30360242";
    case '5':
      return "460603334241301001";
    case '6':
      return "4536160501103041423303";
    case '7':
      return "064610";
    case '8':
      return "13040516364544331302011030414233";
    case '9':
      return "0110304145361605041343";
    case '-':
      return "1333";
    case '_':
      return "0040";
    case '.':
      return "2021";
    case '/':
      return "0046";
    case ' ':
      return "";
    default:
      return "0006464000";
  }
}

}  // namespace

double stroke_width(std::string_view text, double height) {
  if (text.empty()) return 0.0;
  return (kAdvance * static_cast<double>(text.size() - 1) + kColumns) * height / kRows;
}

std::vector<Contour> text_strokes(std::string_view text, double height) {
  std::vector<Contour> strokes;
  for (size_t k = 0; k < text.size(); ++k) {
    const auto c = static_cast<unsigned char>(text[k]);
    const bool small = std::islower(c) != 0;
    const double unit = height / kRows, scale = small ? kSmall * unit : unit;
    std::string_view rest = glyph(small ? static_cast<char>(std::toupper(c)) : text[k]);
    while (!rest.empty()) {
      const std::string_view stroke = rest.substr(0, rest.find(';'));
      rest.remove_prefix(std::min(rest.size(), stroke.size() + 1));
      Contour points(static_cast<Eigen::Index>(stroke.size() / 2), 2);
      for (Eigen::Index p = 0; p < points.rows(); ++p)
        points.row(p) << kAdvance * static_cast<double>(k) * unit +
                             scale * (stroke[2 * static_cast<size_t>(p)] - '0'),
            scale * (stroke[2 * static_cast<size_t>(p) + 1] - '0');
      strokes.push_back(std::move(points));
    }
  }
  return strokes;
}

}  // namespace planewright
