// What the texts of the headers say of a robot.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "backend/cpp/api.h"

namespace robcogen::backend::compatibility {

// The name of each link in LinkIdentifiers, in capitals.
std::vector<std::string> link_identifiers(const model::KinematicTree& tree);

// By the words of headers.inc without their marks: `JOINTS` is the number of joints. `space` is the namespace of the
// headers. Values contain no words.
std::map<std::string, std::string> words(const cpp::Api& api, const std::string& space);

// The text with the values of its words.
std::string filled(const std::string& text, const std::map<std::string, std::string>& words);

}  // namespace robcogen::backend::compatibility
