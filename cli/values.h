// Checks of option values that name the range, before any file is touched.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text.h"

namespace arris::cli {

// All of the text as a number, or nothing; NaN and infinity are numbers here.
std::optional<double> parse_number(std::string_view text);

// A finite number in [low, high]; the description appears in messages and in the help.
CLI::Validator number_in(double low, double high, const char* description);

// A whole number in [low, high].
CLI::Validator whole_number_in(long long low, long long high, const char* description);

// Text that is not empty, for file names.
CLI::Validator not_empty();

// "4G", "1.5 GiB", "512M", "1000000": bytes; K, M, G, T are powers of 1024. Throws
// CLI::ValidationError for anything else, and for 0.
std::size_t parse_bytes(const std::string& text);

// Values by name, in the order in which messages and the help list them.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

// An option whose text is one of the names.
template <class Value>
void add_choice(CLI::App& app, const std::string& name, const Choices<Value>& choices, Value& value,
                const char* description) {
  std::string names;
  for (const auto& choice : choices) names += (names.empty() ? "" : "|") + choice.first;
  const auto set = [name, names, choices, &value](const std::string& text) {
    for (const auto& choice : choices) {
      if (choice.first != text) continue;
      value = choice.second;
      return;
    }
    throw CLI::ValidationError(name, "must be one of " + names + ", not " + quoted(text));
  };
  app.add_option_function<std::string>(name, set, description)->type_name(names);
}

}  // namespace arris::cli
