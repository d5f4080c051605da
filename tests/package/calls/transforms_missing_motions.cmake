# robcogen_add_transforms(TARGET euler): MOTIONS does not exist: @DIR@/euler.motdsl (DEPENDS, when a rule of the build makes it)
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl)
