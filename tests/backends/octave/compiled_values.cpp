// compiled_values STATES FOLDER: what the compiled library of one robot gives. CALLS names the header of its calls.
#include CALLS

int main(int argc, char** argv) {
  return robcogen::octave::write_values(kCalls, std::vector<std::string>(argv, argv + argc), 1);
}
