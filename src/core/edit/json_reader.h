// JsonReading and JsonObject: reading the objects of a project file, key by key. Internal to edit/.
//
// The first thing that is wrong is kept, with its place in the file ("roof.planewright,
// design.layers[0].settings.offset"), and whatever is read after that is without meaning; so a reader reads
// on and asks once, at its end. Keys that nobody asks for become warnings. Threads: one thread.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace planewright {

// "[3]": an entry of the list at `path`.
std::string entry_path(const std::string& path, std::size_t index);

class JsonReading {
 public:
  explicit JsonReading(std::string file) : file_(std::move(file)) {}

  bool failed() const { return error_.has_value(); }
  const std::optional<Error>& error() const { return error_; }
  const std::string& file() const { return file_; }
  // ErrorCode::Unreadable; only the first one counts.
  void fail(const std::string& path, std::string what, std::string remedy = {});
  void fail(Error error);
  void warn(const std::string& path, const std::string& what);
  std::vector<std::string> take_warnings() { return std::move(warnings_); }

  // Values by themselves; `path` is where they stand.
  double number(const nlohmann::json& json, const std::string& path);  // finite
  int integer(const nlohmann::json& json, const std::string& path, int low, int high);
  std::string text(const nlohmann::json& json, const std::string& path);
  // A list; null if it is none.
  const nlohmann::json* list(const nlohmann::json& json, const std::string& path);
  std::vector<double> numbers(const nlohmann::json& json, const std::string& path);
  std::vector<int> integers(const nlohmann::json& json, const std::string& path, int low, int high);
  Points points(const nlohmann::json& json, const std::string& path);  // rows of three

 private:
  std::string file_;
  std::optional<Error> error_;
  std::vector<std::string> warnings_;
};

class JsonObject {
 public:
  // json: null for an object that is not there; every key of it is absent. Fails where it is something else.
  JsonObject(JsonReading& reading, const nlohmann::json* json, std::string path);
  // Warns of the keys that were not asked for.
  ~JsonObject();
  JsonObject(const JsonObject&) = delete;
  JsonObject& operator=(const JsonObject&) = delete;

  std::string path_of(std::string_view key) const;
  const nlohmann::json* find(const char* key);    // null: absent
  const nlohmann::json* needed(const char* key);  // fails if it is absent, and is null then
  void fail(std::string_view key, std::string what, std::string remedy = {});

  // Absent keys leave `value` as it is.
  void read(const char* key, double& value);
  void read(const char* key, bool& value);
  void read(const char* key, std::string& value);
  void read(const char* key, int& value, int low, int high = std::numeric_limits<int>::max());
  // A number that has to be >= 0.
  void read_not_negative(const char* key, double& value);
  // One of several words.
  template <class Enum>
  void read(const char* key, Enum& value, std::span<const std::pair<Enum, const char*>> words) {
    const nlohmann::json* json = find(key);
    if (!json) return;
    std::string known;
    for (const auto& [meaning, word] : words) {
      if (*json == word) {
        value = meaning;
        return;
      }
      known += (known.empty() ? "" : ", ") + std::string(word);
    }
    fail(key, "the value is none of those that there are", "Write one of: " + known);
  }

 private:
  JsonReading& reading_;
  const nlohmann::json* json_;
  std::string path_;
  std::set<std::string, std::less<>> known_;
};

// The word that `words` has for a value. Precondition: it has one.
template <class Enum>
const char* word_for(Enum value, std::span<const std::pair<Enum, const char*>> words) {
  for (const auto& [meaning, word] : words)
    if (meaning == value) return word;
  return words.front().second;
}

}  // namespace planewright
