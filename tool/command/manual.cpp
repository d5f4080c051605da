#include "command/manual.h"

#include <fmt/format.h>

#include <string_view>

#include "driver/driver.h"

namespace robcogen::command {
namespace {

// The text, escaped so that roff shows it unchanged.
std::string in_roff(std::string text) {
  constexpr std::string_view kEllipsis = "\u2026";
  for (std::size_t at = text.find(kEllipsis); at != std::string::npos; at = text.find(kEllipsis))
    text.replace(at, kEllipsis.size(), "...");
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '\'') {
      result += "\\(aq";
    } else {
      result += c;
    }
    begins_line = c == '\n';
  }
  return result;
}

// Lines that roff shows as they stand, indented.
std::string verbatim(const std::string& lines) {
  return ".PP\n.nf\n" + in_roff(lines) + "\n.fi\n";
}

std::string option_entry(const OptionDescription& option) {
  std::string text = ".TP\n";
  if (option.is_positional) {
    text += fmt::format("\\fI{}\\fR", in_roff(option.name));
  } else {
    if (!option.short_name.empty()) text += fmt::format("\\fB{}\\fR, ", in_roff(option.short_name));
    text += fmt::format("\\fB{}\\fR", in_roff(option.name));
    if (option.takes_value) text += " \\fIvalue\\fR";
  }
  text += "\n" + in_roff(option.description) + ".\n";
  if (!option.values.empty())
    text += fmt::format("One of {}.\n", in_roff(fmt::format("{}", fmt::join(option.values, ", "))));
  return text;
}

std::string synopsis(const SubcommandDescription& subcommand) {
  std::string text = fmt::format(".PP\n\\fBrobcogen {}\\fR", in_roff(subcommand.name));
  for (const OptionDescription& option : subcommand.options)
    if (option.is_positional) text += fmt::format(" \\fI{}\\fR", in_roff(option.name));
  return text + " [\\fIoption\\fR \\&...]\n";
}

std::string section(const SubcommandDescription& subcommand) {
  std::string text = ".SS " + in_roff(subcommand.name) + "\n" + in_roff(subcommand.description) + ".\n";
  text += synopsis(subcommand);
  for (const OptionDescription& option : subcommand.options) text += option_entry(option);
  return text + verbatim(subcommand.footer);
}

constexpr const char* kStart =
    ".SH NAME\n"
    "robcogen \\- generate kinematics and dynamics code of robots\n"
    ".SH SYNOPSIS\n"
    "\\fBrobcogen\\fR \\fIcommand\\fR [\\fIargument\\fR \\&...]\n"
    ".SH DESCRIPTION\n"
    "Turns the description of an articulated robot, a document of its own (.kindsl), a URDF or a model of MuJoCo, "
    "into\n"
    "code for that robot's kinematics and dynamics: C++, C, Python, MATLAB, Maxima and JavaScript.\n"
    "Documents of rigid motions (.motdsl) and of coordinate transforms (.ctdsl) become libraries of transforms.\n"
    "CMake projects use the functions of the package robcogen, which call this program.\n";

constexpr const char* kEnd =
    ".SH EXIT STATUS\n"
    "0: success. 1: the input is wrong. 2: wrong usage, or input or output failed. 3: internal fault.\n"
    "On any error no output file is written or changed.\n"
    ".SH SEE ALSO\n"
    "The guides in share/doc/robcogen: README.md, cmake/README.md, runtime/README.md.\n";

}  // namespace

std::string manual(const ProgramDescription& program) {
  std::string text = fmt::format(".TH ROBCOGEN 1 \"\" \"robcogen {}\" \"User Commands\"\n", driver::kVersion);
  text += kStart + verbatim(program.footer) + ".SH COMMANDS\n";
  for (const SubcommandDescription& subcommand : program.subcommands) text += section(subcommand);
  return text + kEnd;
}

}  // namespace robcogen::command
