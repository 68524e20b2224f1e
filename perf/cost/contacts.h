// Which contacts a sweep tries, beside those that the scene has.
#pragma once

#include "perf/cost/ground.h"

namespace ballpark::cost {

/// What was asked for, or if that is nothing the scene's own contacts, those of the other formulation, and more and
/// less exact ones of both. Of a choice without its numbers the usual ones are taken. Says in result.left_out what
/// cannot be had, and in result.remarks what was taken, and what it does to errors.
std::vector<ContactChoice> contacts_to_try(const Ground& ground, const std::vector<ContactChoice>& asked,
                                           Result& result);

/// Do the contacts solve the scene's equations? Those of another formulation, or softer or stiffer, do not.
bool same_equations(const Scene& scene, const ContactChoice& choice);

}  // namespace ballpark::cost
