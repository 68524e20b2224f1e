#include "scenarios/command/terminal.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "scenarios/command/errors.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr std::size_t usual_width = 80, widest = 100, narrowest = 60;

volatile sig_atomic_t interrupt_seen = 0;

bool colour_wanted() {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) && !(no_colour && *no_colour) && !(terminal && std::strcmp(terminal, "dumb") == 0);
}

std::size_t page_width() {
  winsize size{};
  if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual_width;
  return std::clamp<std::size_t>(size.ws_col, narrowest, widest);
}

}  // namespace

Page page() {
  return Page(page_width(), colour_wanted());
}

void print(const std::string& text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written && errno != EPIPE) throw WriteError(fmt::format("cannot write to standard output: {}", strerror(errno)));
}

void complain(const std::string& text) {
  for (const char* line = text.c_str(); *line;) {
    const std::size_t length = std::strcspn(line, "\n");
    std::fprintf(stderr, "ballpark: %.*s\n", static_cast<int>(length), line);
    line += length + (line[length] == '\n');
  }
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) complain("warning: " + warning);
}

void watch_for_interrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_seen = 1; };
  action.sa_flags = SA_RESTART | SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return interrupt_seen != 0;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Progress(std::string label, bool wanted)
    : label_(std::move(label)), on_(wanted && isatty(STDERR_FILENO)), started_(now()) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double fraction) {
  constexpr double delay = 0.3, interval = 0.1;  // s: short runs show nothing, long ones do not flicker
  const double elapsed = now() - started_;
  if (first_fraction_ < 0) {
    first_time_ = elapsed;
    first_fraction_ = fraction;
  }
  if (!on_ || elapsed < delay || elapsed - last_ < interval) return;
  last_ = elapsed;
  drawn_ = true;
  const double pace = (fraction - first_fraction_) / (elapsed - first_time_);
  const std::string left = pace > 0 ? seconds((1 - fraction) / pace) + " left" : "";
  std::fprintf(stderr, "\r\033[K%s  %3.0f %%  %s", label_.c_str(), 100 * fraction, left.c_str());
  std::fflush(stderr);
}

}  // namespace ballpark::command
