/* The part of Simulink's header that the example uses, after its documentation: ports and sizes are members. */
#ifndef SIMSTRUC_H
#define SIMSTRUC_H

typedef double real_T;
typedef int int_T;

typedef struct {
  int parameters, inputs, outputs, sample_times, input_width[8], output_width[8], contiguous[8], feeds[8];
  unsigned options;
  double sample_time, offset_time;
  const real_T *input[8];
  real_T *output[8];
} SimStruct;

#define INHERITED_SAMPLE_TIME (-1.0)
#define SS_OPTION_EXCEPTION_FREE_CODE 1u
#define SS_OPTION_WORKS_WITH_CODE_REUSE 2u
#define ssSetNumSFcnParams(S, n) ((S)->parameters = (n))
#define ssGetNumSFcnParams(S) ((S)->parameters)
#define ssGetSFcnParamsCount(S) 0
#define ssSetNumInputPorts(S, n) (((S)->inputs = (n)), 1)
#define ssSetNumOutputPorts(S, n) (((S)->outputs = (n)), 1)
#define ssSetInputPortWidth(S, port, n) ((S)->input_width[port] = (n))
#define ssSetOutputPortWidth(S, port, n) ((S)->output_width[port] = (n))
#define ssSetInputPortRequiredContiguous(S, port, is) ((S)->contiguous[port] = (is))
#define ssSetInputPortDirectFeedThrough(S, port, is) ((S)->feeds[port] = (is))
#define ssSetNumSampleTimes(S, n) ((S)->sample_times = (n))
#define ssSetOptions(S, flags) ((S)->options = (flags))
#define ssSetSampleTime(S, i, t) ((void)(i), (S)->sample_time = (t))
#define ssSetOffsetTime(S, i, t) ((void)(i), (S)->offset_time = (t))
#define ssGetInputPortSignal(S, port) ((const void *)(S)->input[port])
#define ssGetOutputPortSignal(S, port) ((void *)(S)->output[port])

#endif
