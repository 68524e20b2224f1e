// Exit codes, and the errors that lead to them.
#pragma once

#include <stdexcept>

namespace ballpark::command {

enum Exit { done = 0, check_failed = 1, bad_usage = 2, contract_left = 3, interrupted_exit = 130 };

/// The command line asks for something that does not exist or cannot be. Exit 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file cannot be written where it is wanted: found before anything runs. Exit 2.
class DestinationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writing failed half-way (a full disk, a folder that was removed). Exit 1.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace ballpark::command
