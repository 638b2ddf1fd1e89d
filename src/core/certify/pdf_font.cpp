#include "core/certify/pdf_font.h"

#include <charconv>
#include <sstream>
#include <vector>

namespace planewright {
namespace {

void append_utf8(std::string& out, unsigned code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xF0 | (code >> 18));
    out += static_cast<char>(0x80 | ((code >> 12) & 0x3F));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
}

unsigned hexadecimal(std::string_view digits) {
  unsigned value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value;
}

// UTF-16BE in hexadecimal digits as UTF-8.
std::string utf16(std::string_view digits) {
  std::string out;
  for (size_t i = 0; i + 4 <= digits.size(); i += 4) {
    unsigned code = hexadecimal(digits.substr(i, 4));
    if (code >= 0xD800 && code < 0xDC00 && i + 8 <= digits.size()) {
      code = 0x10000 + ((code - 0xD800) << 10) + (hexadecimal(digits.substr(i + 4, 4)) - 0xDC00);
      i += 4;
    }
    append_utf8(out, code);
  }
  return out;
}

// The tokens of a CMap: "<0041>" (without brackets, marked by a leading '<'), "[", "]" and words.
std::vector<std::string> tokens(const std::string& map) {
  std::vector<std::string> all;
  for (size_t i = 0; i < map.size();) {
    const char c = map[i];
    if (c == '<' && i + 1 < map.size() && map[i + 1] != '<') {
      const size_t end = map.find('>', i);
      if (end == std::string::npos) break;
      all.push_back(map.substr(i, end - i));
      i = end + 1;
    } else if (c == '[' || c == ']') {
      all.emplace_back(1, c);
      ++i;
    } else if (isspace(static_cast<unsigned char>(c)) || c == '<' || c == '>') {
      ++i;
    } else {
      const size_t end = std::min(map.find_first_of(" \t\r\n<>[]", i), map.size());
      all.push_back(map.substr(i, end - i));
      i = end;
    }
  }
  return all;
}

}  // namespace

PdfFont::PdfFont(QPDFObjectHandle font) {
  if (!font.isDictionary()) return;
  if (font.getKey("/Subtype").isNameAndEquals("/Type0")) code_bytes_ = 2;
  if (QPDFObjectHandle map = font.getKey("/ToUnicode"); map.isStream()) {
    const auto data = map.getStreamData();
    read_map(std::string(reinterpret_cast<const char*>(data->getBuffer()), data->getSize()));
  }
  read_widths(font);
}

void PdfFont::read_map(const std::string& map) {
  const auto all = tokens(map);
  const auto hex = [&](size_t i) { return std::string_view(all[i]).substr(1); };
  const auto is_hex = [&](size_t i) { return i < all.size() && all[i].starts_with('<'); };
  std::string mode;
  for (size_t i = 0; i < all.size();) {
    if (all[i].starts_with("begin") || all[i].starts_with("end")) {
      mode = all[i++];
    } else if (mode == "begincodespacerange" && is_hex(i) && is_hex(i + 1)) {
      code_bytes_ = hex(i).size() / 2;
      i += 2;
    } else if (mode == "beginbfchar" && is_hex(i) && is_hex(i + 1)) {
      text_[hexadecimal(hex(i))] = utf16(hex(i + 1));
      i += 2;
    } else if (mode == "beginbfrange" && is_hex(i) && is_hex(i + 1) && i + 2 < all.size()) {
      const unsigned low = hexadecimal(hex(i)), high = hexadecimal(hex(i + 1));
      i += 2;
      if (all[i] == "[") {
        ++i;
        for (unsigned code = low; is_hex(i); ++i, ++code) text_[code] = utf16(hex(i));
        if (i < all.size()) ++i;  // "]"
      } else if (is_hex(i)) {
        const std::string first(hex(i++));
        const unsigned base = hexadecimal(first);
        for (unsigned code = low; code <= high && code - low < 65536; ++code) {
          text_[code].clear();
          append_utf8(text_[code], base + (code - low));
        }
      } else {
        ++i;
      }
    } else {
      ++i;
    }
  }
  if (code_bytes_ != 2) code_bytes_ = 1;
}

void PdfFont::read_widths(QPDFObjectHandle font) {
  if (QPDFObjectHandle matrix = font.getKey("/FontMatrix"); matrix.isArray() && matrix.getArrayNItems() == 6)
    unit_ = matrix.getArrayItem(0).getNumericValue();
  if (QPDFObjectHandle widths = font.getKey("/Widths");
      widths.isArray() && font.getKey("/FirstChar").isInteger()) {
    const auto first = static_cast<unsigned>(font.getKey("/FirstChar").getIntValueAsInt());
    for (int i = 0; i < widths.getArrayNItems(); ++i)
      if (widths.getArrayItem(i).isNumber())
        width_[first + static_cast<unsigned>(i)] = widths.getArrayItem(i).getNumericValue();
  }
  QPDFObjectHandle below = font.getKey("/DescendantFonts");
  if (!below.isArray() || below.getArrayNItems() == 0) return;
  QPDFObjectHandle descendant = below.getArrayItem(0);
  if (!descendant.isDictionary()) return;
  if (descendant.getKey("/DW").isNumber()) default_width_ = descendant.getKey("/DW").getNumericValue();
  QPDFObjectHandle w = descendant.getKey("/W");
  if (!w.isArray()) return;
  for (int i = 0; i + 1 < w.getArrayNItems();) {
    if (!w.getArrayItem(i).isInteger()) break;
    const auto first = static_cast<unsigned>(w.getArrayItem(i).getIntValueAsInt());
    if (QPDFObjectHandle list = w.getArrayItem(i + 1); list.isArray()) {
      for (int k = 0; k < list.getArrayNItems(); ++k)
        if (list.getArrayItem(k).isNumber())
          width_[first + static_cast<unsigned>(k)] = list.getArrayItem(k).getNumericValue();
      i += 2;
    } else if (i + 2 < w.getArrayNItems() && w.getArrayItem(i + 1).isInteger() &&
               w.getArrayItem(i + 2).isNumber()) {
      const auto last = static_cast<unsigned>(w.getArrayItem(i + 1).getIntValueAsInt());
      for (unsigned code = first; code <= last && code - first < 65536; ++code)
        width_[code] = w.getArrayItem(i + 2).getNumericValue();
      i += 3;
    } else {
      break;
    }
  }
}

std::vector<PdfFont::Glyph> PdfFont::glyphs(std::string_view codes) const {
  std::vector<Glyph> all;
  for (size_t i = 0; i + code_bytes_ <= codes.size(); i += code_bytes_) {
    unsigned code = static_cast<unsigned char>(codes[i]);
    if (code_bytes_ == 2) code = code << 8 | static_cast<unsigned char>(codes[i + 1]);
    Glyph glyph;
    if (const auto known = text_.find(code); known != text_.end()) {
      glyph.text = known->second;
    } else {
      append_utf8(glyph.text, code);
    }
    const auto wide = width_.find(code);
    glyph.width = unit_ * (wide == width_.end() ? default_width_ : wide->second);
    all.push_back(std::move(glyph));
  }
  return all;
}

}  // namespace planewright
