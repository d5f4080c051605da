// What a generated library says of itself: constants of the model, and tables of its transforms and Jacobians.
//
// The self-check and the benchmark of a robot are written once over these tables. No Eigen, no allocation.
#pragma once

namespace robcogen::reflection {

struct Joint {
  const char* name;
  bool revolute;
  int parent;  // link index
  int child;   // link index
  // Pose of the joint frame in the parent link's frame: translation (m), then rotation about the intrinsic axes
  // x, y', z'' (rad). Motion is about or along z.
  double translation[3];
  double rotation[3];
};

struct Link {
  const char* name;
  int parent_joint;   // -1: the base
  double mass;        // kg
  double com[3];      // m, link frame
  double inertia[6];  // kg m^2 about the link origin: moments xx yy zz, then products xy xz yz of positive sign
};

struct Frame {
  const char* name;
  int link;  // the link that it moves with
  double translation[3];
  double rotation[3];
};

// left_X_right, three forms; each kernel reads q and writes a matrix column by column.
struct Transform {
  const char* name;
  int left;   // frame indices
  int right;
  void (*homogeneous)(const double* q, double* X) noexcept;  // 4 x 4
  void (*motion)(const double* q, double* X) noexcept;       // 6 x 6, angular first
  void (*force)(const double* q, double* X) noexcept;        // 6 x 6, angular first
};

// left_J_right: velocity of the origin of `right` with respect to `left`, in coordinates of `left`, angular rows first.
struct Jacobian {
  const char* name;
  int left;
  int right;
  const int* columns;  // joint index of each column
  int column_count;
  void (*kernel)(const double* q, double* J) noexcept;  // 6 x column_count
};

struct OperationCount {
  int mul;
  int add;
  int div;
  int sqrt;
  int sincos;
  int instructions;
  int critical_path;
};

struct Function {
  const char* name;  // the kernel's name
  OperationCount count;
};

template <class T>
struct Table {
  const T* data;
  int size;
  constexpr const T& operator[](int i) const { return data[i]; }
  constexpr const T* begin() const { return data; }
  constexpr const T* end() const { return data + size; }
};

struct Robot {
  const char* name;
  bool floating_base;
  Table<Link> links;  // [0] is the base
  Table<Joint> joints;
  Table<Frame> frames;
  Table<Transform> transforms;
  Table<Jacobian> jacobians;
  Table<Function> functions;
};

}  // namespace robcogen::reflection
