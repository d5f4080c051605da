# robcogen_add_transforms(TARGET euler): DOUBLE_ONLY is for C++: LANGUAGES must include cpp
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl LANGUAGES maxima DOUBLE_ONLY)
