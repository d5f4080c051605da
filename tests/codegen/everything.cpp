// Every generated file of every sample in one unit.
#include "cart_pole/cart_pole.h"
#include "cart_pole/reflection.h"
#include "hopper/hopper.h"
#include "hopper/reflection.h"
#include "literals/literals.h"
#include "literals/reflection.h"
#include "plinth/plinth.h"
#include "plinth/reflection.h"
#include "robot/reflection.h"
#include "robot/robot.h"
#include "robot/robot_.h"

#include "without_eigen.cpp"
