// Internal to this folder: how each library is loaded.
#pragma once

#include "peers/peer.h"

namespace robcogen::peers {

// Throws a std::exception with the reason if the library cannot represent the robot.
using Load = std::unique_ptr<Peer>(const Subject& subject);

// Null if the library was not found.
#ifdef ROBCOGEN_HAS_KDL
Load load_kdl_tree, load_kdl_chain;
#else
inline constexpr Load *load_kdl_tree = nullptr, *load_kdl_chain = nullptr;
#endif
#ifdef ROBCOGEN_HAS_DART
Load load_dart;
#else
inline constexpr Load* load_dart = nullptr;
#endif
#ifdef ROBCOGEN_HAS_MUJOCO
Load load_mujoco;
#else
inline constexpr Load* load_mujoco = nullptr;
#endif
#ifdef ROBCOGEN_HAS_RBDL
Load load_rbdl;
#else
inline constexpr Load* load_rbdl = nullptr;
#endif
#ifdef ROBCOGEN_HAS_PINOCCHIO
Load load_pinocchio;
#else
inline constexpr Load* load_pinocchio = nullptr;
#endif

}  // namespace robcogen::peers
