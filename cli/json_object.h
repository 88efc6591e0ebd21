// One JSON object for standard output: two-space indent, keys in the order given.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

namespace arris::cli {

class JsonObject {
 public:
  void add(const char* key, bool value);
  void add(const char* key, double value);  // null if it is not finite: JSON has no such numbers
  void add(const char* key, const std::string& text);
  template <class Integer>
  requires std::is_integral_v<Integer> &&
      (!std::is_same_v<Integer, bool>)void add(const char* key, Integer value) {
    add_raw(key, std::to_string(value));
  }
  void print() const;

 private:
  void add_raw(const char* key, const std::string& value);
  std::string fields_;
};

}  // namespace arris::cli
