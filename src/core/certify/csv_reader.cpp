#include "core/certify/csv_reader.h"

#include <algorithm>

namespace planewright {

int CsvTable::column(std::string_view name) const {
  const auto at = std::find(header.begin(), header.end(), name);
  return at == header.end() ? -1 : static_cast<int>(at - header.begin());
}

Result<CsvTable> read_csv(std::string_view content, const std::string& name) {
  CsvTable table;
  std::vector<std::string> row;
  std::string field;
  int line = 1;
  const auto error = [&](std::string what) {
    return fail(ErrorCode::Unreadable, std::move(what), name + ":" + std::to_string(line));
  };
  size_t i = 0;
  bool begun = false;  // something of a row since the last line end
  while (i < content.size()) {
    begun = true;
    if (content[i] == '"') {
      for (++i;; ++i) {
        if (i >= content.size()) return error("a quote that is not closed");
        if (content[i] == '"') {
          if (i + 1 >= content.size() || content[i + 1] != '"') break;
          ++i;  // two of them are one
        }
        if (content[i] == '\n') ++line;
        field += content[i];
      }
      ++i;
    } else {
      while (i < content.size() && content[i] != ',' && content[i] != '\r' && content[i] != '\n') {
        if (content[i] == '"') return error("a quote inside a field");
        field += content[i++];
      }
    }
    row.push_back(std::move(field));
    field.clear();
    if (i >= content.size()) break;
    if (content[i] == ',') {
      ++i;
      if (i >= content.size()) break;
      continue;
    }
    if (content.substr(i, 2) != "\r\n") return error("a field that ends in neither comma nor CRLF");
    i += 2;
    begun = false;
    if (table.header.empty()) {
      table.header = std::move(row);
    } else if (row.size() != table.header.size()) {
      return error(std::to_string(row.size()) + " fields, the header has " +
                   std::to_string(table.header.size()));
    } else {
      table.rows.push_back(std::move(row));
    }
    row.clear();
    ++line;
  }
  if (begun) return error("the last line does not end");
  if (table.header.empty()) return error("no header");
  return table;
}

}  // namespace planewright
