// What a PDF font says of its codes: the text they mean, and how wide they are. Internal to certify/.
#pragma once

#include <map>
#include <qpdf/QPDFObjectHandle.hh>
#include <string>
#include <string_view>
#include <vector>

namespace planewright {

class PdfFont {
 public:
  PdfFont() = default;
  // font: the font's dictionary.
  explicit PdfFont(QPDFObjectHandle font);

  struct Glyph {
    std::string text;    // UTF-8
    double width = 0.0;  // of a font of size 1
  };
  // The codes of a string as the text operators have it.
  std::vector<Glyph> glyphs(std::string_view codes) const;

 private:
  void read_map(const std::string& map);
  void read_widths(QPDFObjectHandle font);

  size_t code_bytes_ = 1;
  double unit_ = 0.001;           // of widths; Type 3 fonts have their own
  double default_width_ = 500.0;  // where the font is silent
  std::map<unsigned, std::string> text_;
  std::map<unsigned, double> width_;
};

}  // namespace planewright
