# robcogen_add_transforms(TARGET euler): MOTIONS or TRANSFORMS is missing
robcogen_add_transforms(TARGET euler)
