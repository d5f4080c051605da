template <class Scalar>
void loop(const Scalar* q, Scalar* tau) noexcept {
  for (int i = 0; i < 6; ++i) tau[i] = q[i];
}
