// What a sweep says: the Pareto front, where curves cross, and the setting to take.
#pragma once

#include "perf/cost/result.h"

namespace ballpark::cost {

/// Does the point count among the ways to run the scene?
bool counts(const Point& point);
/// Marks the points that no other is as accurate and as fast as; returns them from inaccurate to accurate.
std::vector<std::size_t> mark_front(Result& result);
/// Which curve is cheapest at which error, in sentences; only inside what was measured.
std::vector<std::string> crossovers(const Result& result);
/// One curve beside another at the smallest error that both were measured at; "" if there is none.
std::string comparison(const Result& result, const std::string& cheap, const std::string& dear);

/// How near each formulation of contacts comes to the reference, in sentences; none where one alone was tried.
std::vector<std::string> formulations(const Result& result);

/// Indices of the settings whose error is at most `tolerance` / `margin`, the fastest first.
std::vector<std::size_t> accurate_enough(const Result& result, double tolerance, double margin);
/// Indices of the settings whose run takes at most so many seconds, the most accurate first.
std::vector<std::size_t> cheap_enough(const Result& result, double seconds);

}  // namespace ballpark::cost
