// CSV by RFC 4180: commas, CRLF, quotes. Internal to certify/. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace planewright {

struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // as long as the header
  int column(std::string_view name) const;     // -1: none
};

// Fails with ErrorCode::Unreadable, with the line: a quote that is not closed or stands inside a field, a
// line end other than CRLF, a row of another length than the header, a last line without end.
Result<CsvTable> read_csv(std::string_view content, const std::string& name);

}  // namespace planewright
