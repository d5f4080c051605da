/* Included at the end of an S-function: the entry points that Simulink calls. Here the test calls them. */
void sfunction_sizes(SimStruct *S);
void sfunction_outputs(SimStruct *S);
void sfunction_sizes(SimStruct *S) {
  mdlInitializeSizes(S);
  mdlInitializeSampleTimes(S);
}
void sfunction_outputs(SimStruct *S) {
  mdlOutputs(S, 0);
  mdlTerminate(S);
}
