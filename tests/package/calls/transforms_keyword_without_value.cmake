# robcogen_add_transforms(TARGET euler): missing value: MOTIONS
robcogen_add_transforms(TARGET euler MOTIONS)
