#include "backend/cpp/layout.h"

#include <algorithm>

#include "support/concat.h"

namespace robcogen::backend::cpp {
namespace {

std::string blanks(std::size_t count) {
  return std::string(count, ' ');
}

std::string text(const Field& field) {
  if (!field.template_name.empty()) return field.template_name + "<" + joined(field.items, ", ") + ">";
  return field.braces ? braced(field.items) : field.items.front();
}

// The field, followed by a comma, as lines with this indentation.
std::string lines(const Field& field, std::size_t indent) {
  const std::string line = blanks(indent) + text(field) + ",\n";
  if (line.size() <= kColumns + 1) return line;
  const std::string separator = ",\n" + blanks(indent + 4);
  if (!field.template_name.empty())
    return blanks(indent) + field.template_name + "<\n" + blanks(indent + 4) + joined(field.items, separator) + ">,\n";
  if (!field.braces) return line;
  return blanks(indent) + "{\n" + blanks(indent + 4) + joined(field.items, separator) + ",\n" + blanks(indent) + "},\n";
}

// The items with commas, on as few lines as possible, followed by `end`.
std::string filled(const std::vector<std::string>& items, const std::string& end, std::size_t indent) {
  std::string result, row = blanks(indent);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string next = items[i] + (i + 1 < items.size() ? "," : end);
    if (row.size() > indent && row.size() + 1 + next.size() > kColumns) {
      result += row + "\n";
      row = blanks(indent);
    }
    row += (row.size() > indent ? " " : "") + next;
  }
  return result + row + "\n";
}

}  // namespace

std::string declaration(
    const std::string& head,
    const std::vector<std::string>& parameters,
    const std::string& tail,
    std::size_t indent) {
  const std::string line = blanks(indent) + head + "(" + joined(parameters, ", ") + ")" + tail;
  if (line.size() <= kColumns || parameters.empty()) return line + "\n";
  // The text after the parameters of a member function may be on a line of its own.
  if (const std::size_t end = line.size() - tail.size(); tail.rfind(" const ", 0) == 0 && end <= kColumns)
    return line.substr(0, end) + "\n" + blanks(indent + 4) + tail.substr(1) + "\n";
  const std::string separator = "\n" + blanks(indent + 4);
  return blanks(indent) + head + "(" + separator + joined(parameters, "," + separator) + ")" + tail + "\n";
}

std::string call(const std::string& head, const std::vector<std::string>& arguments, std::size_t indent) {
  const std::string line = blanks(indent) + head + "(" + joined(arguments, ", ") + ");";
  if (line.size() <= kColumns || arguments.empty()) return line + "\n";
  return blanks(indent) + head + "(\n" + filled(arguments, ");", indent + 4);
}

std::string template_call(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail,
    std::size_t indent) {
  const std::string line = blanks(indent) + head + "<" + joined(items, ", ") + ">";
  if (line.size() + tail.size() + 1 <= kColumns) return line + tail + ";\n";
  if (line.size() + 1 <= kColumns) return line + "(\n" + blanks(indent + 4) + tail.substr(1) + ";\n";
  return blanks(indent) + head + "<\n" + filled(items, ">" + tail + ";", indent + 4);
}

std::string remarked_list(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::vector<std::string>& remarks,
    std::size_t indent) {
  if (items.empty()) return blanks(indent) + head + " = {};\n";
  std::size_t width = 0;
  for (const std::string& item : items) width = std::max(width, item.size());
  std::string result = blanks(indent) + head + " = {\n";
  for (std::size_t i = 0; i < items.size(); ++i)
    result += blanks(indent + 4) + items[i] + "," + blanks(width - items[i].size()) + "  // " + remarks[i] + "\n";
  return result + blanks(indent) + "};\n";
}

std::string numbered_list(const std::string& head, const std::vector<std::string>& items, std::size_t indent) {
  const std::string line = blanks(indent) + head + " = " + braced(items) + ";";
  if (line.size() <= kColumns) return line + "\n";
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < items.size(); ++i) numbers.push_back(std::to_string(i));
  return remarked_list(head, items, numbers, indent);
}

std::string text_list(const std::string& head, const std::vector<std::string>& texts) {
  constexpr std::size_t kIndent = 4, kAround = 3;  // quotes and a comma
  const std::size_t room = kColumns - kIndent - kAround;
  std::vector<std::string> items;
  std::size_t longest = 0;
  for (const std::string& text : texts) {
    items.push_back(cpp::quoted(text));
    longest = std::max(longest, items.back().size());
  }
  if (longest + kIndent + std::string(",  // 1000").size() <= kColumns) return numbered_list(head, items);
  std::string result = head + " = {\n";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    result += blanks(kIndent) + "// " + std::to_string(i) + "\n";
    std::string rest = texts[i];
    while (rest.size() > room) {
      const std::size_t cut = rest.rfind(' ', room - 1) + 1;
      if (cut == 0) break;
      result += blanks(kIndent) + cpp::quoted(rest.substr(0, cut)) + "\n";
      rest.erase(0, cut);
    }
    result += blanks(kIndent) + cpp::quoted(rest) + ",\n";
  }
  return result + "};\n";
}

std::string table(const std::string& head, const std::vector<std::vector<Field>>& rows) {
  std::vector<std::string> items, numbers;
  std::size_t width = 0;
  for (const std::vector<Field>& row : rows) {
    std::vector<std::string> fields;
    for (const Field& field : row) fields.push_back(text(field));
    items.push_back(braced(fields));
    numbers.push_back(std::to_string(items.size() - 1));
    width = std::max(width, items.back().size());
  }
  const std::size_t around = std::string("    ,  // ").size();
  if (rows.empty() || width + around + numbers.back().size() <= kColumns) return remarked_list(head, items, numbers);
  std::string result = head + " = {\n";
  for (const std::vector<Field>& row : rows) {
    result += "    {\n";
    for (const Field& field : row) result += lines(field, 8);
    result += "    },\n";
  }
  return result + "};\n";
}

std::string paragraphs(const std::vector<std::string>& parts) {
  std::size_t size = 0;
  for (const std::string& part : parts) size += part.size() + 1;
  std::string result;
  result.reserve(size);
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    if (!result.empty()) result += "\n";
    result += part;
  }
  return result;
}

std::string in_namespace(const std::string& name, const std::string& body) {
  if (body.empty()) return "";
  return concat({"namespace ", name, " {\n\n", body, "\n}  // namespace ", name, "\n"});
}

}  // namespace robcogen::backend::cpp
