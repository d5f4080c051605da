// LinkDataMap and JointDataMap of the first RobCoGen: a value for each link or joint.
#pragma once

#include <Eigen/Core>

#include <ostream>

namespace robcogen::compatibility {

// `Ids` has the enumeration `Identifier` and the `names` of its values.
template <class T, class Ids>
class DataMap {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  DataMap() {}
  DataMap(const T& value) { *this = value; }
  DataMap& operator=(const T& value) {
    for (T& item : data_) item = value;
    return *this;
  }

  T& operator[](typename Ids::Identifier which) { return data_[which]; }
  const T& operator[](typename Ids::Identifier which) const { return data_[which]; }

  // The values in the order of the identifiers.
  T* begin() { return data_; }
  const T* begin() const { return data_; }

  friend std::ostream& operator<<(std::ostream& out, const DataMap& map) {
    for (std::size_t i = 0; i < Ids::names.size(); ++i) out << "   " << Ids::names[i] << " = " << map.data_[i];
    return out;
  }

 private:
  T data_[Ids::names.size()];
};

}  // namespace robcogen::compatibility
