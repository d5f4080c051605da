# robcogen_add_transforms(TARGET euler): LANGUAGES: 'fortran' is not one of cpp c matlab maxima javascript
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl LANGUAGES fortran)
