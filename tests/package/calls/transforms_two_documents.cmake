# robcogen_add_transforms(TARGET euler): MOTIONS and TRANSFORMS exclude each other
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl TRANSFORMS euler.ctdsl)
