# robcogen_add_transforms(TARGET euler): NAME is given 2 times; it has one value
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl NAME a NAME b)
