# robcogen_add_transforms(TARGET euler): LANGUAGES does not know 'fortran'; it knows cpp matlab maxima
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl LANGUAGES fortran)
