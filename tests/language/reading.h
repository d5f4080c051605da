// Reads documents from texts and files, with their messages.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../golden_messages.h"
#include "language/desired/document.h"
#include "language/kinematics/document.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"

namespace robcogen::test {

inline std::shared_ptr<const Source> source(std::string text) {
  return std::make_shared<Source>("test", std::move(text));
}

inline std::vector<std::string> codes(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& d : diagnostics.all()) result.push_back(d.code);
  return result;
}

// Reads a document; expects no messages.
inline language::kinematics::Document read_robot(const std::string& text) {
  Diagnostics diagnostics;
  language::kinematics::Document document = language::kinematics::parse(source(text), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render() << text;
  return document;
}

inline language::desired::Document read_desired(const std::string& text) {
  Diagnostics diagnostics;
  language::desired::Document document = language::desired::parse(source(text), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render() << text;
  return document;
}

inline language::motion::Document read_motions(const std::string& text) {
  Diagnostics diagnostics;
  language::motion::Document document = language::motion::parse(source(text), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render() << text;
  return document;
}

inline language::transforms::Document read_transforms(const std::string& text) {
  Diagnostics diagnostics;
  language::transforms::Document document = language::transforms::parse(source(text), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render() << text;
  return document;
}

// The codes of all diagnostics of a document, in the order in which they were found.
inline std::vector<std::string> robot_codes(const std::string& text) {
  Diagnostics diagnostics;
  language::kinematics::parse(source(text), diagnostics);
  return codes(diagnostics);
}

inline std::vector<std::string> desired_codes(const std::string& text) {
  Diagnostics diagnostics;
  language::desired::parse(source(text), diagnostics);
  return codes(diagnostics);
}

using Codes = std::vector<std::string>;

}  // namespace robcogen::test
