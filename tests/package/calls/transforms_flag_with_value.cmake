# robcogen_add_transforms(TARGET euler): unknown argument '0'; the keywords are TARGET MOTIONS
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl DOUBLE_ONLY 0)
