template <class Scalar>
void branch(const Scalar* q, Scalar* tau) noexcept {
  if (q[0] > 0) tau[0] = q[1];
}
