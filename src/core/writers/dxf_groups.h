// The grammar of a DXF file: pairs of a group code and a value, each on a line of its own, and handles.
// Internal to writers/. Threads: one writer per thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace planewright {

class DxfGroups {
 public:
  // handles: whether records have handles, owners and subclass markers (from R13 on).
  explicit DxfGroups(bool handles) : handles_(handles) {}

  bool handles() const { return handles_; }
  void text(int code, std::string_view value);
  void integer(int code, int value);
  // AutoCAD wants a point in its real numbers.
  void real(int code, double value);
  void point(int code, double x, double y);            // codes n, n + 10
  void point(int code, double x, double y, double z);  // codes n, n + 10, n + 20
  void handle(int code, std::uint32_t handle);         // hexadecimal

  // The next free handle.
  std::uint32_t take_handle() { return next_handle_++; }
  // "0 TYPE" with a handle of its own, which is returned, and its owner; without handles the type alone.
  std::uint32_t record(std::string_view type, std::uint32_t owner, int handle_code = 5);
  void record(std::string_view type, std::uint32_t owner, std::uint32_t own, int handle_code = 5);
  // "100 AcDb...", nothing without handles.
  void subclass(std::string_view marker);

  void begin_section(std::string_view name);
  void end_section();

  void append(const DxfGroups& other) { out_ += other.out_; }
  void reserve(size_t bytes) { out_.reserve(bytes); }
  std::string take() { return std::move(out_); }

 private:
  void code(int code);

  bool handles_;
  std::uint32_t next_handle_ = 0x100;  // those below are given by name
  std::string out_;
};

// Text as DXF keeps it in one line: characters outside ASCII as \U+XXXX (beyond U+FFFF a surrogate pair),
// '^' and "%%", which mean something there, written so that they mean themselves.
std::string dxf_text(std::string_view utf8);

}  // namespace planewright
