/* An S-function of Simulink: joint accelerations of HyL from positions, velocities and joint forces, a block to integrate twice.

       mex -Igenerated/c forward_dynamics.c generated/c/in_c_hyl_c/model.c generated/c/in_c_hyl_c/forward_dynamics.c

   after
       robcogen generate hyl.kindsl -o generated --name hyl --namespace in_c --language c --algorithms forward_dynamics */
#ifndef S_FUNCTION_NAME
#define S_FUNCTION_NAME forward_dynamics
#endif
#define S_FUNCTION_LEVEL 2

#include <in_c_hyl_c/forward_dynamics.h>

#include "simstruc.h"

enum { kInputs = 3 };

static void mdlInitializeSizes(SimStruct *S) {
  int i;
  ssSetNumSFcnParams(S, 0);
  if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S)) return;
  if (!ssSetNumInputPorts(S, kInputs) || !ssSetNumOutputPorts(S, 1)) return;
  for (i = 0; i < kInputs; ++i) {
    ssSetInputPortWidth(S, i, in_c_hyl_dof);
    ssSetInputPortRequiredContiguous(S, i, 1);
    ssSetInputPortDirectFeedThrough(S, i, 1);
  }
  ssSetOutputPortWidth(S, 0, in_c_hyl_dof);
  ssSetNumSampleTimes(S, 1);
  /* The function has no state and no memory: any number of blocks, in any thread. */
  ssSetOptions(S, SS_OPTION_EXCEPTION_FREE_CODE | SS_OPTION_WORKS_WITH_CODE_REUSE);
}

static void mdlInitializeSampleTimes(SimStruct *S) {
  ssSetSampleTime(S, 0, INHERITED_SAMPLE_TIME);
  ssSetOffsetTime(S, 0, 0.0);
}

static void mdlOutputs(SimStruct *S, int_T task) {
  const real_T *q = (const real_T *)ssGetInputPortSignal(S, 0);
  const real_T *qd = (const real_T *)ssGetInputPortSignal(S, 1);
  const real_T *tau = (const real_T *)ssGetInputPortSignal(S, 2);
  (void)task;
  in_c_hyl_forward_dynamics(q, qd, tau, (real_T *)ssGetOutputPortSignal(S, 0));
}

static void mdlTerminate(SimStruct *S) {
  (void)S;
}

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
