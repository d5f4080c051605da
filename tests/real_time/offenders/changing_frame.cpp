void fill(volatile char* values, unsigned count);

void changing_frame(unsigned count) {
  fill(static_cast<volatile char*>(__builtin_alloca(count)), count);
}

void fill(volatile char* values, unsigned count) {
  for (unsigned i = 0; i < count; ++i) values[i] = 0;
}
