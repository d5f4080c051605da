/* Prints joint forces of the arm in four states, in units of 1e-5 N m: on a bare board through semihosting, elsewhere
   as any program. */
#include <ur_c/inverse_dynamics.h>

static int text(char* buffer, long value) {
  char digits[12];
  int n = 0, length = 0;
  unsigned long rest = value < 0 ? 0UL - (unsigned long)value : (unsigned long)value;
  do {
    digits[n++] = (char)('0' + rest % 10);
    rest /= 10;
  } while (rest);
  if (value < 0) buffer[length++] = '-';
  while (n) buffer[length++] = digits[--n];
  buffer[length++] = '\n';
  buffer[length] = 0;
  return length;
}

#ifdef __arm__
static int semihost(int operation, const void* argument) {
  register int r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}
static void print(const char* line) {
  semihost(0x04, line);
}
#else
#include <stdio.h>
static void print(const char* line) {
  fputs(line, stdout);
}
#endif

int main(void) {
  char line[16];
  int state, i;
  for (state = 0; state < 4; ++state) {
    float q[ur_dof], qd[ur_dof], qdd[ur_dof], tau[ur_dof];
    for (i = 0; i < ur_dof; ++i) {
      q[i] = 0.3f * (float)(i + 1) - 0.7f * (float)state;
      qd[i] = 0.1f * (float)(state - i);
      qdd[i] = 0.2f * (float)(i - 2);
    }
    ur_inverse_dynamicsf(q, qd, qdd, tau);
    for (i = 0; i < ur_dof; ++i) {
      text(line, (long)(tau[i] * 1e5f));
      print(line);
    }
  }
  return 0;
}

#ifdef __arm__
int __errno;
void reset(void);
void reset(void) {
  /* The floating-point unit: CPACR. */
  *(volatile unsigned*)0xE000ED88 |= 0xFu << 20;
  __asm__ volatile("dsb\n isb");
  main();
  semihost(0x18, (const void*)0x20026);
  for (;;) {
  }
}
__attribute__((section(".vectors"), used)) static const void* const vectors[2] = {(void*)0x20010000, (void*)reset};
#endif
