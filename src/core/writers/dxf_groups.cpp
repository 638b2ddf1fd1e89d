#include "core/writers/dxf_groups.h"

#include <array>
#include <charconv>

#include "core/writers/clean_text.h"
#include "core/writers/number_text.h"

namespace planewright {
namespace {

void append_hex(std::string& out, std::uint32_t value, int digits = 0) {
  std::array<char, 16> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, 16);
  for (auto length = end.ptr - buffer.data(); length < digits; ++length) out += '0';
  for (const char* c = buffer.data(); c != end.ptr; ++c)
    out += *c >= 'a' ? static_cast<char>(*c - 'a' + 'A') : *c;
}

}  // namespace

void DxfGroups::code(int code) {
  if (code < 100) out_ += code < 10 ? "  " : " ";
  append_number(out_, code);
  out_ += '\n';
}

void DxfGroups::text(int c, std::string_view value) {
  code(c);
  out_ += value;
  out_ += '\n';
}

void DxfGroups::integer(int c, int value) {
  code(c);
  append_number(out_, value);
  out_ += '\n';
}

void DxfGroups::real(int c, double value) {
  code(c);
  const size_t begin = out_.size();
  append_number(out_, value);
  if (out_.find_first_of(".e", begin) == std::string::npos) out_ += ".0";
  out_ += '\n';
}

void DxfGroups::point(int c, double x, double y) {
  real(c, x);
  real(c + 10, y);
}

void DxfGroups::point(int c, double x, double y, double z) {
  point(c, x, y);
  real(c + 20, z);
}

void DxfGroups::handle(int c, std::uint32_t handle) {
  code(c);
  append_hex(out_, handle);
  out_ += '\n';
}

std::uint32_t DxfGroups::record(std::string_view type, std::uint32_t owner, int handle_code) {
  const std::uint32_t own = handles_ ? take_handle() : 0;
  record(type, owner, own, handle_code);
  return own;
}

void DxfGroups::record(std::string_view type, std::uint32_t owner, std::uint32_t own, int handle_code) {
  text(0, type);
  if (!handles_) return;
  handle(handle_code, own);
  handle(330, owner);
}

void DxfGroups::subclass(std::string_view marker) {
  if (handles_) text(100, marker);
}

void DxfGroups::begin_section(std::string_view name) {
  text(0, "SECTION");
  text(2, name);
}

void DxfGroups::end_section() {
  text(0, "ENDSEC");
}

std::string dxf_text(std::string_view utf8) {
  std::string out;
  const auto append_unicode = [&](std::uint32_t unit) {
    out += "\\U+";
    append_hex(out, unit, 4);
  };
  const std::vector<char32_t> characters = clean_characters(utf8);
  for (size_t i = 0; i < characters.size(); ++i) {
    const char32_t c = characters[i];
    if (c == U'^') {
      out += "^ ";
    } else if (c == U'%' && ((i > 0 && characters[i - 1] == U'%') ||
                             (i + 1 < characters.size() && characters[i + 1] == U'%'))) {
      out += "%%%";
    } else if (c < 0x80) {
      out += static_cast<char>(c);
    } else if (c < 0x10000) {
      append_unicode(c);
    } else {
      append_unicode(0xD800 + ((c - 0x10000) >> 10));
      append_unicode(0xDC00 + ((c - 0x10000) & 0x3FF));
    }
  }
  return out;
}

}  // namespace planewright
