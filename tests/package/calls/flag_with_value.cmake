# robcogen_add_robot(TARGET hyl): unknown argument 'OFF'; the keywords are TARGET MODEL DESIRED NAME
robcogen_add_robot(TARGET hyl MODEL hyl.urdf FLOATING_BASE OFF)
