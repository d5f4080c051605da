# robcogen_add_transforms(TARGET euler): MOTIONS does not exist: @DIR@/euler.motdsl (name its rule in DEPENDS if the build generates it)
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl)
