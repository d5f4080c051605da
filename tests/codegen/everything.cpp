// Every generated file of every sample in one unit.
#include "cart_pole/cart_pole.h"
#include "cart_pole/reflection.h"
#include "legs/floating/hopper/hopper.h"
#include "legs/floating/hopper/reflection.h"
#include "literals/literals.h"
#include "literals/reflection.h"
#include "my/robcogen/class/robot/reflection.h"
#include "my/robcogen/class/robot/robot.h"
#include "plinth/plinth.h"
#include "plinth/reflection.h"

#include "without_eigen.cpp"
