void fill(volatile double* values, int count);

void large_frame() {
  volatile double values[20000];
  fill(values, 20000);
}

void fill(volatile double* values, int count) {
  for (int i = 0; i < count; ++i) values[i] = i;
}
