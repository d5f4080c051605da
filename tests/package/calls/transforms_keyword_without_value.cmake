# robcogen_add_transforms(TARGET euler): MOTIONS without a value
robcogen_add_transforms(TARGET euler MOTIONS)
