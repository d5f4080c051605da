// Comments may say if, for and why?
template <class Scalar>
void straight(const Scalar* q, Scalar* tau) noexcept {
  tau[0] = q[0] * q[1];
}
