# robcogen_add_transforms(TARGET euler): unknown argument 'MODEL' 'euler.motdsl'; the keywords are TARGET
robcogen_add_transforms(TARGET euler MODEL euler.motdsl)
