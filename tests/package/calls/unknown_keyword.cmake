# robcogen_add_robot(TARGET hyl): unknown argument 'MODLE' 'hyl.kindsl'; the keywords are TARGET MODEL DESIRED NAME
robcogen_add_robot(TARGET hyl MODLE hyl.kindsl)
