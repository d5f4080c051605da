/* The S-function between its ports: sizes, and the outputs that inverse dynamics takes back to the inputs. */
#include <in_c_hyl_c/in_c_hyl_c.h>
#include <math.h>
#include <stdio.h>

#include "simstruc.h"

void sfunction_sizes(SimStruct *S);
void sfunction_outputs(SimStruct *S);

int main(void) {
  const double q[3] = {0.3, -0.8, 1.1}, qd[3] = {1.0, 2.0, -3.0}, tau[3] = {40.0, 5.0, -2.0};
  double qdd[3] = {0.0, 0.0, 0.0}, back[3];
  SimStruct block = {0};
  int i;
  sfunction_sizes(&block);
  if (block.inputs != 3 || block.outputs != 1 || block.output_width[0] != 3 || block.sample_times != 1) return 1;
  for (i = 0; i < 3; ++i)
    if (block.input_width[i] != 3 || !block.contiguous[i] || !block.feeds[i]) return 2;
  block.input[0] = q;
  block.input[1] = qd;
  block.input[2] = tau;
  block.output[0] = qdd;
  sfunction_outputs(&block);
  in_c_hyl_inverse_dynamics(q, qd, qdd, back);
  for (i = 0; i < 3; ++i)
    if (!(fabs(back[i] - tau[i]) < 1e-10)) {
      printf("joint %d: %g, not %g\n", i, back[i], tau[i]);
      return 3;
    }
  return 0;
}
