# Wrong calls; ../calls.cmake says how they are read.

#### transforms_single_precision_without_cpp
# robcogen_add_transforms(TARGET euler): SINGLE_PRECISION is for C++: LANGUAGES must include cpp
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl LANGUAGES maxima SINGLE_PRECISION)

#### transforms_both_precisions
# robcogen_add_transforms(TARGET euler): SINGLE_PRECISION and DOUBLE_ONLY, the default, exclude each other
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl SINGLE_PRECISION DOUBLE_ONLY)

#### transforms_flag_with_value
# robcogen_add_transforms(TARGET euler): unknown argument '0'; the keywords are TARGET MOTIONS
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl DOUBLE_ONLY 0)

#### transforms_keyword_without_value
# robcogen_add_transforms(TARGET euler): missing value: MOTIONS
robcogen_add_transforms(TARGET euler MOTIONS)

#### transforms_missing_motions
# robcogen_add_transforms(TARGET euler): MOTIONS does not exist: @DIR@/euler.motdsl (name its rule in DEPENDS if the build generates it)
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl)

#### transforms_name_taken
# robcogen_add_transforms(TARGET other): NAME 'euler' is taken by target 'euler'
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_euler euler)
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/euler.motdsl "")
robcogen_add_transforms(TARGET other NAME euler MOTIONS euler.motdsl)

#### transforms_name_twice
# robcogen_add_transforms(TARGET euler): NAME is given 2 times; it has one value
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl NAME a NAME b)

#### transforms_no_document
# robcogen_add_transforms(TARGET euler): MOTIONS or TRANSFORMS is missing
robcogen_add_transforms(TARGET euler)

#### transforms_no_target
# robcogen_add_transforms(): TARGET is missing
robcogen_add_transforms(MOTIONS euler.motdsl)

#### transforms_other_document
# robcogen_add_transforms(TARGET hyl): MOTIONS must be a .motdsl document, not '.kindsl': hyl.kindsl
robcogen_add_transforms(TARGET hyl MOTIONS hyl.kindsl)

#### transforms_two_documents
# robcogen_add_transforms(TARGET euler): MOTIONS and TRANSFORMS exclude each other
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl TRANSFORMS euler.ctdsl)

#### transforms_unknown_keyword
# robcogen_add_transforms(TARGET euler): unknown argument 'MODEL' 'euler.motdsl'; the keywords are TARGET
robcogen_add_transforms(TARGET euler MODEL euler.motdsl)

#### transforms_unknown_language
# robcogen_add_transforms(TARGET euler): LANGUAGES: 'fortran' is not one of cpp c matlab maxima javascript
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl LANGUAGES fortran)

#### transforms_wrong_derivative
# robcogen_add_transforms(TARGET euler): DERIVATIVES: 'transforms.homogeneous.A_X_B:' is not function:input or function:input,input, such as inverse_dynamics:q,qd, or all
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl DERIVATIVES transforms.homogeneous.A_X_B:)
