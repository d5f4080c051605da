# A filter of Doxygen, which reads /// only: comments in front of declarations become documentation. The text of comments stays
# as it is, so characters that Doxygen would interpret are escaped, except in code (indented by four blanks or more).

# What a brace opens: t a namespace or a type, whose declarations are documented, b a body or a list.
function opens(text) {
  return text ~ /(^|[^a-z_])(namespace|class|struct|enum|union|extern "C")([^a-z_]|$)/ && text !~ /\)[^)]*$/ ? "t" : "b"
}
function is_documented(  i) {
  for (i = 1; i <= depth; ++i) if (scope[i] == "b") return 0
  return parentheses == 0
}
function escaped(text) {
  if (text ~ /^ ? ? ?[^ ]/) gsub(/[\\@<>#%&$"|*_`~]/, "\\\\&", text)
  return text
}
function follow(line,  i, c) {
  gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
  gsub(/'([^'\\]|\\.)'/, "0", line)
  sub(/\/\/.*/, "", line)
  if (line ~ /^ *#/) return
  sub(/^ *(public|protected|private):/, "", line)
  for (i = 1; i <= length(line); ++i) {
    c = substr(line, i, 1)
    if (c == "{") { scope[++depth] = parentheses ? "b" : opens(statement); statement = "" }
    else if (c == "}") { if (depth > 0) --depth; statement = "" }
    else if (c == ";" && parentheses == 0) statement = ""
    else statement = statement c
    if (c == "(") ++parentheses
    if (c == ")") --parentheses
  }
  statement = statement " "
}

FNR == 1 && /^\/\/ / { print "/// \\file"; in_head = 1 }
/^ *\/\/( |$)/ && is_documented() && statement ~ /^ *$/ {
  match($0, /^ *\/\//)
  print substr($0, 1, RLENGTH) "/" escaped(substr($0, RLENGTH + 1))
  next
}
# A comment behind a member documents it.
/[,;] +\/\/ / && depth > 0 && scope[depth] == "t" && is_documented() {
  match($0, /[,;] +\/\/ /)
  head = substr($0, 1, RSTART + RLENGTH - 2)
  print head "/<" escaped(substr($0, RSTART + RLENGTH - 1))
  follow(head)
  next
}
{ print; follow($0) }
