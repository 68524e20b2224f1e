#include "perf/machine.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace ballpark::perf {

namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::size_t system_value(int name) {
  const long value = sysconf(name);
  return value > 0 ? static_cast<std::size_t>(value) : 0;
}

// From the kernel rather than sysconf, which on virtual machines tells of caches that are not there.
std::size_t cache_bytes(const std::string& level) {
  for (int index = 0;; ++index) {
    const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + "/";
    std::ifstream level_file(folder + "level"), size_file(folder + "size");
    std::string found_level;
    std::size_t kilobytes = 0;
    if (!(level_file >> found_level)) return 0;
    if (found_level == level && size_file >> kilobytes) return kilobytes * 1024;
  }
}

double load_of_last_minute() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace

Machine machine() {
  return {.processor = processor_name(),
          .threads = static_cast<int>(std::thread::hardware_concurrency()),
          .level2_bytes = cache_bytes("2"),
          .level3_bytes = cache_bytes("3"),
          .memory_bytes = system_value(_SC_PHYS_PAGES) * system_value(_SC_PAGESIZE),
#ifdef __clang__
          .compiler = "clang " __clang_version__,
#else
          .compiler = "g++ " __VERSION__,
#endif
          .load = load_of_last_minute()};
}

}  // namespace ballpark::perf
