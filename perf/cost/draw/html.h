// Pages that open in a browser, made from a template.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace ballpark::cost::draw {

/// JSON that holds no "<": nothing in it can end a script element or begin a comment. In JSON a "<" stands in strings
/// alone, where its escape is the same.
std::string inert(const std::string& json);

/// The template with a text in place of each mark. Marks are given in the order of the template, so that what is put
/// in is never searched.
std::string filled(std::string_view page_template,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> parts);

}  // namespace ballpark::cost::draw
