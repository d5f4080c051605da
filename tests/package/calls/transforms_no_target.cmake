# robcogen_add_transforms(): TARGET is missing
robcogen_add_transforms(MOTIONS euler.motdsl)
