#include "json_object.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "text.h"

namespace arris::cli {

void JsonObject::add(const char* key, bool value) {
  add_raw(key, value ? "true" : "false");
}

void JsonObject::add(const char* key, double value) {
  add_raw(key, std::isfinite(value) ? exact_number(value) : "null");
}

void JsonObject::add(const char* key, const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) {
      out += c;
    } else {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(c));
      out += escape.data();
    }
  }
  out += '"';
  add_raw(key, out);
}

void JsonObject::add_raw(const char* key, const std::string& value) {
  fields_ += fields_.empty() ? "\n  \"" : ",\n  \"";
  fields_.append(key).append("\": ").append(value);
}

void JsonObject::print() const {
  std::printf("{%s\n}\n", fields_.c_str());
}

}  // namespace arris::cli
