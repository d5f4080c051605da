# robcogen_add_robot(TARGET hyl): LANGUAGES c needs a C compiler: write enable_language(C), or project(… LANGUAGES C CXX),
# before this call
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES cpp c)
