// How an Error travels inside the library: as an exception that the public functions catch.
#pragma once

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

#include "arris/error.h"

namespace arris {

// Carries an Error up to the public function that turns it into a Result. Never leaves the library.
class Failure : public std::exception {
 public:
  explicit Failure(Error error) : error_(std::move(error)) {}
  Failure(ErrorCode code, std::string message, std::string remedy)
      : error_{code, std::move(message), std::move(remedy)} {}
  const char* what() const noexcept override { return error_.message.c_str(); }
  const Error& error() const noexcept { return error_; }

 private:
  Error error_;
};

// Runs `body` and turns whatever it throws into an Error. The only door out of the library.
template <class Body>
auto guarded(Body&& body) noexcept -> Result<decltype(body())> {
  try {
    if constexpr (std::is_void_v<decltype(body())>) {
      body();
      return {};
    } else {
      return body();
    }
  } catch (const Failure& f) {
    return f.error();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::out_of_memory, "the machine has no memory left for this work",
                 "use fewer points or a machine with more memory"};
  } catch (const std::exception& e) {
    return Error{ErrorCode::internal, std::string("unexpected failure: ") + e.what(),
                 "please report it with the input"};
  }
}

}  // namespace arris
