# robcogen_add_robot(TARGET hyl): the library needs a C++ compiler: write enable_language(CXX), or project(… LANGUAGES CXX),
# before this call
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)
